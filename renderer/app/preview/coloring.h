// SPDX-License-Identifier: MIT
#pragma once

#include <nori/bitmap.h>

#include <cstdint>
#include <vector>

namespace preview {

enum class View { Image, Reference, Split, Difference };

/// How an image is shown.
struct Look {
    View view = View::Image; ///< all but Image need a reference
    double exposure = 0;     ///< values are multiplied by 2^exposure
    double split = 0.5;      ///< View::Split: share of the width, from the left, that is the image
    bool markFaulty = true;  ///< pixels that are not a number, infinite or negative stand out

    bool operator==(const Look &other) const {
        return view == other.view && exposure == other.exposure && split == other.split &&
               markFaulty == other.markFaulty;
    }
};

/// Radiance to a colour of the window, 0xAABBGGRR; the bytes are those of nori's PNG files.
std::uint32_t displayColor(const nori::Color3f &value, bool markFaulty);

/// (x - r) / (|r| + 0.01) of the mean of the channels; not a number if one of them is not finite.
double signedDifference(const nori::Color3f &value, const nori::Color3f &reference);

/// The whole image in colours, shape [rows, columns]. Difference: blue to orange for -1 to 1 after
/// the exposure.
/// \param reference  of the image's size
std::vector<std::uint32_t> colorize(const nori::Bitmap &image, const nori::Bitmap *reference,
                                    const Look &look);

/// The image in another size, each pixel that of the nearest place.
nori::Bitmap resized(const nori::Bitmap &image, Eigen::Index rows, Eigen::Index columns);

} // namespace preview
