// SPDX-License-Identifier: MIT
#pragma once

#include <span>

namespace statistics {

/// How far one channel of an image is from a reference. For people: none of them is a test.
struct ImageErrors {
    double mean = 0.0;          ///< of the image
    double referenceMean = 0.0; ///< of the reference
    double rmse = 0.0;          ///< square root of the mean squared difference
    double relMse = 0.0;        ///< mean of (X - R)^2 / (R^2 + 1e-2 mean(R)^2)
    double smape = 0.0;         ///< mean of 2 |X - R| / (|X| + |R| + 1e-3 |mean(R)|), in [0, 2]
    double largest = 0.0;       ///< |X - R|
};

/// \param image, reference  pixels in any order; all must be finite
/// \throws std::invalid_argument  if the sizes differ or are 0
ImageErrors imageErrors(std::span<const float> image, std::span<const float> reference);

/// Whether two independent renders differ by as much as their noise says.
struct NoiseTest {
    double ratio = 1.0;  ///< mean squared difference / mean sum of both variances
    double z = 0.0;      ///< of ratio - 1; below 0: the images share noise, or one was smoothed
    double pValue = 1.0; ///< two-sided, normal
};

/// Mean over pixels of d^2 - v, Studentised by its scatter over the pixels.
/// \param differences  per pixel
/// \param variances    of the differences, as the renders estimate them; shape of `differences`
/// \throws std::invalid_argument  if the sizes differ or are below 2
NoiseTest noiseTest(std::span<const double> differences, std::span<const double> variances);

} // namespace statistics
