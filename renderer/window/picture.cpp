// SPDX-License-Identifier: MIT
#include <png.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>
#include <window/picture.h>
#include <window/style.h>

namespace window {

namespace {

constexpr int kChannels = 3;

/// A font atlas without ImGui's context: nothing but the shapes of the glyphs.
struct Glyphs {
    ImFontAtlas atlas;
    ImFont *font = nullptr;
    unsigned char *alpha = nullptr;
    int width = 0;
    int height = 0;

    Glyphs() {
        font = addFont(atlas, 1.0f, 1);
        atlas.GetTexDataAsAlpha8(&alpha, &width, &height);
    }
};

int rounded(float x) {
    return static_cast<int>(std::lround(x));
}

void fail(png_structp, png_const_charp message) {
    throw std::runtime_error(message);
}

void append(png_structp png, png_bytep bytes, png_size_t count) {
    static_cast<std::string *>(png_get_io_ptr(png))
        ->append(reinterpret_cast<const char *>(bytes), count);
}

} // namespace

Picture::Picture(int width, int height, std::uint32_t color)
    : m_width(width),
      m_height(height),
      m_pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), color) {}

void Picture::blend(int x, int y, std::uint32_t color, unsigned alpha) {
    if (x < 0 || y < 0 || x >= m_width || y >= m_height)
        return;
    std::uint32_t &pixel =
        m_pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) +
                 static_cast<std::size_t>(x)];
    std::uint32_t mixed = 0xff000000U;
    for (unsigned shift = 0; shift < 24; shift += 8) {
        const unsigned over = (color >> shift) & 0xffU;
        const unsigned under = (pixel >> shift) & 0xffU;
        mixed |= ((over * alpha + under * (255U - alpha)) / 255U) << shift;
    }
    pixel = mixed;
}

void Picture::fill(int left, int top, int width, int height, std::uint32_t color) {
    for (int y = top; y < top + height; ++y) {
        for (int x = left; x < left + width; ++x)
            blend(x, y, color, 255U);
    }
}

void Picture::write(int left, int top, const std::string &text, std::uint32_t color) {
    const Glyphs glyphs;
    auto x = static_cast<float>(left);
    const char *at = text.c_str();
    const char *const end = at + text.size();
    while (at < end) {
        unsigned code = 0;
        at += ImTextCharFromUtf8(&code, at, end);
        const ImFontGlyph *const glyph = glyphs.font->FindGlyph(static_cast<ImWchar>(code));
        if (glyph == nullptr)
            continue;
        const int u = rounded(glyph->U0 * static_cast<float>(glyphs.width));
        const int v = rounded(glyph->V0 * static_cast<float>(glyphs.height));
        const int width = rounded(glyph->X1 - glyph->X0);
        const int height = rounded(glyph->Y1 - glyph->Y0);
        for (int row = 0; row < height; ++row) {
            for (int column = 0; column < width; ++column)
                blend(static_cast<int>(x + glyph->X0) + column,
                      top + static_cast<int>(glyph->Y0) + row, color,
                      glyphs.alpha[(v + row) * glyphs.width + u + column]);
        }
        x += glyph->AdvanceX;
    }
}

void Picture::writePng(const std::string &file, const std::string &key,
                       const std::string &text) const {
    std::string bytes;
    {
        png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, nullptr);
        png_infop info = png_create_info_struct(png);
        const auto destroy = [&info](png_structp p) {
            png_destroy_write_struct(&p, &info);
        };
        const std::unique_ptr<png_struct, decltype(destroy)> guard(png, destroy);
        png_set_write_fn(png, &bytes, append, nullptr);
        png_set_IHDR(png, info, static_cast<png_uint_32>(m_width),
                     static_cast<png_uint_32>(m_height), 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                     PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        std::string keyCopy = key;
        std::string textCopy = text;
        png_text chunk{};
        chunk.compression = PNG_ITXT_COMPRESSION_zTXt;
        chunk.key = keyCopy.data();
        chunk.text = textCopy.data();
        chunk.itxt_length = textCopy.size();
        png_set_text(png, info, &chunk, 1);
        png_write_info(png, info);
        std::vector<png_byte> row(static_cast<std::size_t>(m_width) * kChannels);
        for (int y = 0; y < m_height; ++y) {
            for (std::size_t i = 0; i < row.size(); ++i) {
                const std::uint32_t pixel =
                    m_pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) +
                             i / kChannels];
                row[i] = static_cast<png_byte>((pixel >> (8U * (i % kChannels))) & 0xffU);
            }
            png_write_row(png, row.data());
        }
        png_write_end(png, nullptr);
    }
    std::FILE *const out = std::fopen(file.c_str(), "wb");
    const bool written =
        out != nullptr && std::fwrite(bytes.data(), 1, bytes.size(), out) == bytes.size();
    const bool closed = out != nullptr && std::fclose(out) == 0;
    if (!written || !closed)
        throw std::runtime_error(file + ": cannot be written");
}

} // namespace window
