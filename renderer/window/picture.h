// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace window {

/// An image in memory with text on it, drawn without a graphics card.
class Picture {
public:
    /// \param color  of every pixel, 0xAABBGGRR
    Picture(int width, int height, std::uint32_t color);

    /// A rectangle; what is outside of the picture is cut off.
    void fill(int left, int top, int width, int height, std::uint32_t color);

    /// One line of UTF-8 in the font of the windows. \param top  of the line
    void write(int left, int top, const std::string &text, std::uint32_t color);

    /// \param key, text  of an iTXt chunk
    /// \throws std::runtime_error  if the file cannot be written
    void writePng(const std::string &file, const std::string &key, const std::string &text) const;

private:
    void blend(int x, int y, std::uint32_t color, unsigned alpha);

    int m_width;
    int m_height;
    std::vector<std::uint32_t> m_pixels;
};

} // namespace window
