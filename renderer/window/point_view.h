// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <imgui/imgui.h>

namespace window {

/// A corner of a line, or a point: where it is, and its colour as in ImGui (0xAABBGGRR).
struct Vertex {
    float x = 0;
    float y = 0;
    float z = 0;
    std::uint32_t color = 0xffffffff;
};

/// Column-major, as OpenGL wants it.
using Matrix = std::array<float, 16>;

/// Millions of points and lines, drawn into a texture that ImGui shows. Needs a current context.
class PointView {
public:
    PointView() = default;
    ~PointView();
    PointView(const PointView &) = delete;
    PointView &operator=(const PointView &) = delete;
    PointView(PointView &&) = delete;
    PointView &operator=(PointView &&) = delete;

    void setPoints(const std::vector<Vertex> &points);
    /// \param lines  two corners each
    void setLines(const std::vector<Vertex> &lines);

    /// Draws if anything has changed since.
    /// \param transform  to clip space
    /// \return  the texture; its first row is the lowest
    ImTextureID draw(int width, int height, const Matrix &transform, float pointSize,
                     const ImVec4 &background);
    void release();

private:
    struct Batch {
        unsigned array = 0;
        unsigned buffer = 0;
        int count = 0;
    };

    void upload(Batch &batch, const std::vector<Vertex> &vertices);
    void createProgram();
    void resize(int width, int height);

    Batch m_points;
    Batch m_lines;
    unsigned m_program = 0;
    int m_transformLocation = -1;
    int m_sizeLocation = -1;
    unsigned m_framebuffer = 0;
    unsigned m_color = 0;
    unsigned m_depth = 0;
    int m_width = 0;
    int m_height = 0;
    bool m_changed = true;
    Matrix m_transform{};
    float m_pointSize = 0;
    ImVec4 m_background;
};

} // namespace window
