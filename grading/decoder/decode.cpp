// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>

#include <decoder/decode.h>

namespace decoder {

using protocol::Image;
using protocol::ImageAnswer;
using protocol::ImageFault;

namespace {

struct Format {
    const char *magic;
    std::size_t magicSize;
    Image (*decode)(const char *data, std::size_t size);
};

constexpr Format kFormats[] = {
    {"\x76\x2f\x31\x01", 4, decodeExr},
    {"\x89PNG\r\n\x1a\n", 8, decodePng},
};

ImageAnswer failed(ImageFault fault, const std::string &message) {
    ImageAnswer answer;
    answer.fault = fault;
    answer.message = message;
    return answer;
}

} // namespace

void requireSize(std::int64_t width, std::int64_t height, std::size_t channels) {
    const std::string size = std::to_string(width) + " x " + std::to_string(height) + " pixels";
    if (width < 1 || height < 1 || channels == 0)
        throw DecodeError(ImageFault::Unsupported,
                          "an image of " + size + " in " + std::to_string(channels) + " channels");
    constexpr auto kMost = static_cast<std::int64_t>(protocol::kLargestImage);
    if (width > kMost || height > kMost || width * height > kMost ||
        static_cast<std::size_t>(width * height) > protocol::kLargestImage / channels)
        throw DecodeError(ImageFault::TooLarge,
                          size + " in " + std::to_string(channels) + " channels are too many");
}

ImageAnswer decode(const char *data, std::size_t size) {
    const auto *const format =
        std::find_if(std::begin(kFormats), std::end(kFormats), [&](const Format &candidate) {
            return size >= candidate.magicSize &&
                   std::memcmp(data, candidate.magic, candidate.magicSize) == 0;
        });
    if (format == std::end(kFormats))
        return failed(ImageFault::NotAnImage,
                      size == 0 ? "the file is empty" : "neither an OpenEXR nor a PNG file");
    try {
        ImageAnswer answer;
        answer.image = format->decode(data, size);
        const auto byName = [](const protocol::Channel &a, const protocol::Channel &b) {
            return a.name < b.name;
        };
        std::sort(answer.image.channels.begin(), answer.image.channels.end(), byName);
        return answer;
    } catch (const DecodeError &error) {
        return failed(error.fault(), error.what());
    } catch (const std::bad_alloc &) {
        return failed(ImageFault::TooLarge, "there is not enough memory for it");
    } catch (const std::exception &error) {
        return failed(ImageFault::Broken, error.what());
    }
}

} // namespace decoder
