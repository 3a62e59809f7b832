// SPDX-License-Identifier: MIT
#pragma once

#include <grader/checks/emitter_samples.h>
#include <grader/diagnosis/guess.h>

#include <vector>

namespace grader {

/// A density of an area light against the right one, with what the ratio may depend on.
struct DensityRatio {
    double ratio = 1;
    double cosine = 1; ///< |n . wi|
    double distance = 1;
};

/// The law ratio = constant * cosine^p * distance^q, and the mistake that it is.
std::vector<Guess> guessAreaDensity(const std::vector<DensityRatio> &ratios);

/// How the value of Emitter::sample follows from eval and pdf.
/// \param other  diagnosis where it does in no known way
std::vector<Guess> guessSampleValue(const std::vector<EmitterSampleRow> &rows, const char *other);

/// Directions of an environment that are not uniform.
/// \param uniform  pdf says that they are
std::vector<Guess> guessDirections(const std::vector<EmitterSampleRow> &rows, bool uniform);

/// What a direction is that is not from `ref` to `p`.
std::vector<Guess> guessDirectionToLight(const std::vector<EmitterSampleRow> &rows);

} // namespace grader
