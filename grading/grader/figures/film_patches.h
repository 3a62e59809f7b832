// SPDX-License-Identifier: MIT
#pragma once

#include <protocol/image.h>
#include <statistics/filtered_tiles.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace grader {

/// A rectangle of pixels of an image.
struct Patch {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    std::size_t pixels() const { return static_cast<std::size_t>(width) * height; }
};

/// The parts of an image that are rendered anew.
struct PatchPlan {
    int width = 0; ///< of the whole image [pixels]
    int height = 0;
    statistics::GaussianFilm film;
    std::vector<Patch> patches;
};

/// Colours of one patch's pixels: shape [pixels], rows from the top.
using PatchPixels = std::vector<std::array<float, 3>>;

/// One image, seen through the patches.
using PatchImage = std::vector<PatchPixels>;

/// At most `wanted` squares of `side` pixels, one at a random place of each cell of a grid, so far
/// apart that no sample counts for two of them; fewer and smaller ones in a small image.
std::vector<Patch> spreadPatches(int width, int height, int wanted, int side, std::uint64_t seed);

/// Points for protocol::Op::Film: `samples` per pixel, uniform in each pixel whose samples count
/// for a patch, patch by patch.
std::vector<float> filmPoints(const PatchPlan &plan, int samples, std::uint64_t seed);

/// Puts samples through the film as Nori does: those that are negative or not finite are dropped.
/// \param radiance  of each point: shape [points, 3]
PatchImage develop(const PatchPlan &plan, const std::vector<float> &points,
                   const std::vector<float> &radiance, int samples);

/// Cuts the patches out of a whole image with channels R, G, B.
PatchImage cutOut(const PatchPlan &plan, const protocol::Image &image);

/// The level in [0, 255], with its fraction, that nori's PNGs show a value in linear light with.
double pngLevel(float linear);

} // namespace grader
