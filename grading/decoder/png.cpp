// SPDX-License-Identifier: MIT
#include <png.h>

#include <array>
#include <cmath>

#include <decoder/decode.h>

namespace decoder {

using protocol::Channel;
using protocol::Image;
using protocol::ImageFault;

namespace {

/// libpng's own view of a file; released with it.
struct PngFile {
    png_image view{};

    PngFile() { view.version = PNG_IMAGE_VERSION; }

    ~PngFile() { png_image_free(&view); }

    PngFile(const PngFile &) = delete;
    PngFile(PngFile &&) = delete;
    PngFile &operator=(const PngFile &) = delete;
    PngFile &operator=(PngFile &&) = delete;

    [[noreturn]] void fail() const {
        throw DecodeError(ImageFault::Broken, static_cast<const char *>(view.message));
    }
};

/// sRGB's curve, IEC 61966-2-1. (libpng's own linear values are off by up to 0.007.)
float linear(int value) {
    const double v = value / 255.0;
    return static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
}

} // namespace

Image decodePng(const char *data, std::size_t size) {
    PngFile file;
    if (png_image_begin_read_from_memory(&file.view, data, size) == 0)
        file.fail();
    const bool hasAlpha = (file.view.format & PNG_FORMAT_FLAG_ALPHA) != 0;
    const std::size_t count = hasAlpha ? 4 : 3;
    requireSize(file.view.width, file.view.height, count);

    file.view.format = hasAlpha ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
    const std::size_t pixels = std::size_t{file.view.width} * file.view.height;
    std::vector<png_byte> values(pixels * count);
    if (png_image_finish_read(&file.view, nullptr, values.data(), 0, nullptr) == 0)
        file.fail();

    Image image;
    image.format = "png";
    image.width = static_cast<int>(file.view.width);
    image.height = static_cast<int>(file.view.height);
    std::array<float, 256> curve{};
    for (std::size_t i = 0; i < curve.size(); ++i)
        curve[i] = linear(static_cast<int>(i));
    constexpr const char *kNames[] = {"R", "G", "B", "A"};
    for (std::size_t c = 0; c < count; ++c) {
        Channel channel{kNames[c], std::vector<float>(pixels)};
        for (std::size_t i = 0; i < pixels; ++i)
            channel.values[i] = c == 3 ? static_cast<float>(values[i * count + c]) / 255.0F
                                       : curve[values[i * count + c]];
        image.channels.push_back(std::move(channel));
    }
    return image;
}

} // namespace decoder
