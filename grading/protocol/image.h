// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace protocol {

/// Plane of one quantity: `R`, `variance.G`, `count.Y`.
struct Channel {
    std::string name;
    std::vector<float> values; ///< shape [height * width], rows from the top; may hold NaN
};

/// What a decoder makes of an image file.
struct Image {
    std::string format; ///< `exr`, `png`
    int width = 0;
    int height = 0;
    std::vector<Channel> channels;                 ///< sorted by name; each name once
    std::map<std::string, std::string> attributes; ///< what the file says about itself, as text

    /// Null if there is no such channel.
    const Channel *channel(const std::string &name) const;
};

/// Why there is no image.
enum class ImageFault : unsigned {
    NotAnImage = 1, ///< neither OpenEXR nor PNG
    Broken,         ///< cut short or damaged
    Unsupported, ///< a kind of image that nothing here writes: deep, subsampled, without channels
    TooLarge,    ///< more than kLargestImage values
};

/// Values of all channels together; 64 layers of the course's resolution, or 5800^2 in RGB.
constexpr std::size_t kLargestImage = 100'000'000;

/// A decoder's answer: an image, or why there is none.
struct ImageAnswer {
    Image image;
    ImageFault fault{}; ///< 0: `image` holds
    std::string message;
};

/// \throws std::length_error  beyond 4 GiB
std::string encode(const ImageAnswer &answer);

/// \throws std::runtime_error  on anything that encode() of a sound image could not have written
ImageAnswer decodeImageAnswer(const char *data, std::size_t size);

} // namespace protocol
