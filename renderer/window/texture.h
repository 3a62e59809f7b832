// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <imgui/imgui.h>

namespace window {

/// OpenGL's name of a texture as ImGui's back-end takes it.
inline ImTextureID textureId(unsigned name) {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): ImGui 1.86 makes every kind of texture a void *
    return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(name));
}

/// An image that was drawn by us, in the memory of the graphics card. Needs a current context.
class Texture {
public:
    Texture() = default;
    ~Texture();
    Texture(const Texture &) = delete;
    Texture &operator=(const Texture &) = delete;
    Texture(Texture &&) = delete;
    Texture &operator=(Texture &&) = delete;

    /// \param pixels  shape [height, width], row 0 on top, 0xAABBGGRR as ImGui's colours
    void upload(int width, int height, const std::vector<std::uint32_t> &pixels);
    void release();

    ImTextureID id() const { return textureId(m_name); }

    bool isEmpty() const { return m_name == 0; }

    int width() const { return m_width; }

    int height() const { return m_height; }

private:
    unsigned m_name = 0;
    int m_width = 0;
    int m_height = 0;
};

} // namespace window
