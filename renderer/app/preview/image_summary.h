// SPDX-License-Identifier: MIT
#pragma once

#include <nori/bitmap.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace preview {

/// Faulty pixels whose places are kept.
constexpr size_t kListedPixels = 64;

struct ImageSummary {
    std::array<double, 3> mean{}; ///< of the finite values; 0 if there are none, as the next ones
    std::array<double, 3> smallest{};
    std::array<double, 3> largest{};
    size_t notANumber = 0; ///< pixels with such a channel
    size_t infinite = 0;
    size_t negative = 0;
    std::vector<nori::Point2i> faulty; ///< (column, row) of the first kListedPixels, line by line
};

ImageSummary summarize(const nori::Bitmap &image);

/// Not a number, infinite or negative in a channel.
bool isFaulty(const nori::Color3f &value);

/// How far an image is from a reference, over all channels of the pixels that are finite in both.
struct ImageError {
    double rmse = 0;
    double relative = 0; ///< mean of (x - r)^2 / (r^2 + 0.01)
    double bias = 0;     ///< mean of x over mean of r, less 1; 0 if the reference is black
};

/// \return  nothing if the sizes differ
std::optional<ImageError> measureError(const nori::Bitmap &image, const nori::Bitmap &reference);

/// Lines of text for people.
std::vector<std::string> describe(const ImageSummary &summary);
std::vector<std::string> describe(const ImageError &error);

} // namespace preview
