// SPDX-License-Identifier: MIT
#include "tile_map.h"

#include <grader/error.h>

#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace grader {

namespace {

constexpr double kFull = 6.0; ///< |z| of the full colour
constexpr int kGap = 8;       ///< pixels between the parts
constexpr int kScaleHeight = 16;

using Rgb = std::array<png_byte, 3>;

constexpr Rgb kPaper{255, 255, 255};
constexpr Rgb kOutline{60, 60, 60};

/// From blue over white to red: ColorBrewer's RdBu ends.
Rgb colorOf(double z) {
    constexpr std::array<double, 3> kDark{5, 48, 97};
    constexpr std::array<double, 3> kBright{103, 0, 31};
    const double t = std::min(1.0, std::fabs(z) / kFull);
    Rgb color{};
    for (std::size_t i = 0; i < 3; ++i)
        color[i] =
            static_cast<png_byte>(std::lround(255 + t * ((z < 0 ? kDark : kBright)[i] - 255)));
    return color;
}

class Canvas {
public:
    Canvas(int width, int height)
        : m_width(width),
          m_height(height),
          m_pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), kPaper) {}

    void fill(int left, int top, int width, int height, const Rgb &color) {
        for (int y = std::max(0, top); y < std::min(m_height, top + height); ++y) {
            for (int x = std::max(0, left); x < std::min(m_width, left + width); ++x)
                m_pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) +
                         static_cast<std::size_t>(x)] = color;
        }
    }

    std::string png() const {
        png_image image{};
        image.version = PNG_IMAGE_VERSION;
        image.width = static_cast<png_uint_32>(m_width);
        image.height = static_cast<png_uint_32>(m_height);
        image.format = PNG_FORMAT_RGB;
        png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
        std::string bytes(size, '\0');
        if (png_image_write_to_memory(&image, bytes.data(), &size, 0, m_pixels.data(), 0,
                                      nullptr) == 0)
            throw GraderError(std::string("the tile map cannot be written: ") +
                              static_cast<const char *>(image.message));
        bytes.resize(size);
        return bytes;
    }

private:
    int m_width;
    int m_height;
    std::vector<Rgb> m_pixels;
};

void drawTiles(const statistics::TileWelchResult &result, int left, int width, int height,
               Canvas &canvas) {
    const int size = statistics::TileWelchConfig{}.tileSize;
    for (const statistics::Tile &tile : result.tiles) {
        const int tileWidth = std::min(size, width - tile.x);
        const int tileHeight = std::min(size, height - tile.y);
        const Rgb color = colorOf(tile.score);
        canvas.fill(left + tile.x, tile.y, tileWidth, tileHeight,
                    tile.test.gateMet ? color : kOutline);
        if (!tile.test.gateMet)
            canvas.fill(left + tile.x + 1, tile.y + 1, tileWidth - 2, tileHeight - 2, color);
    }
}

} // namespace

std::string tileMapPng(const Comparison &comparison) {
    if (comparison.channels.empty() || !comparison.channels.front().tiles)
        throw GraderError("there are no tiles to draw: nothing could be tested");
    const auto count = static_cast<int>(comparison.channels.size());
    const int width = count * comparison.width + (count - 1) * kGap;
    Canvas canvas(width, comparison.height + kGap + kScaleHeight);
    for (int c = 0; c < count; ++c)
        drawTiles(*comparison.channels[static_cast<std::size_t>(c)].tiles,
                  c * (comparison.width + kGap), comparison.width, comparison.height, canvas);
    for (int x = 0; x < width; ++x)
        canvas.fill(x, comparison.height + kGap, 1, kScaleHeight,
                    colorOf(kFull * (2.0 * (x + 0.5) / width - 1)));
    return canvas.png();
}

} // namespace grader
