// SPDX-License-Identifier: MIT
#pragma once

#include <grader/figures/film_patches.h>

#include <array>

namespace grader {

/// How pixels are compared: as they are, or as the 8-bit levels of a PNG.
enum class PixelScale { Linear, Levels };

/// A figure and three independent renders of the same patches.
struct FigurePatches {
    PatchImage figure;
    std::array<PatchImage, 3> own;
    PixelScale scale = PixelScale::Linear;
    /// Whether the renders have as many samples per pixel as the figure is said to have, not fewer.
    bool equalSamples = true;
};

/// What the patches say. Effects are estimates, for people; the p-values are what is decided on.
struct FigureFindings {
    std::size_t patches = 0; ///< with noise or a difference
    double meanP = 1.0;      ///< of the patches' means being alike
    double moreNoiseP = 1.0;
    double lessNoiseP = 1.0;   ///< 1 without equal samples
    double meanError = 0.0;    ///< relative: figure / own - 1, over all patches
    double meanMde = 0.0;      ///< relative error of every patch that would be found
    double noiseRatio = 1.0;   ///< variance of the figure's pixels over that of the own ones
    double moreNoiseMde = 0.0; ///< the least ratio above 1 that would be found
    double lessNoiseMde = 0.0; ///< the largest one below 1; 0: none
    /// What the patches' means differ by, over what pixels do, each in units of its noise: 1 for
    /// another amount of noise; more for a smoothed image, and for other values (the mean of a
    /// patch has less noise than a pixel).
    double smoothness = 1.0;
    double correlation = 1.0; ///< of the patches' means with the own ones
};

/// Level of each of the three tests of one look; with two looks a right figure is flagged with a
/// chance below 1.8e-5.
inline constexpr double kFigureLevel = 3e-6;

/// Compares a figure with renders by two sign tests over the patches: if all four images come from
/// one program, then |figure - A| is above |B - C| with a probability of 1/2, whatever the law of
/// the noise, the film and the rounding are (statistics.md §2b: equal samples cancel skewness).
/// With fewer samples in the renders the probability is smaller still, so that what is found there
/// is sure as well, but less is found. Differences below 1 % of a patch, or one level of a PNG, do
/// not count.
/// \throws std::invalid_argument  if the images have different patches
FigureFindings examineFigure(const FigurePatches &patches);

} // namespace grader
