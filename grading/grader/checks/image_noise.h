// SPDX-License-Identifier: MIT
#pragma once

#include <grader/checks/check.h>
#include <grader/checks/radiance_samples.h>
#include <statistics/replicates.h>

#include <optional>
#include <vector>

namespace grader {

constexpr double kWide = 3.29; ///< standard errors of an interval of 99.9 %

/// What the noise of a hand-in says: of four images of `kNoiseRepeats` samples
/// per pixel, two in each of two processes, as random numbers may be kept in a static variable.
struct ImageNoise {
    statistics::RatioEstimate between; ///< variance of the images' means, over within
    statistics::RatioEstimate error;   ///< squared, of all together, over what it should be
    double errorP = 1;                 ///< p-value of `error` being 1
    double promised = 0;               ///< mean of what the squared error should be
    statistics::RatioEstimate decline; ///< squared error of all together over that of one
    statistics::CommonError common;    ///< of the two images of a process
    double mean = 0;                   ///< of our own image
    std::optional<CheckResult> failure;

    /// Rms of `common`, as a part of the mean.
    double bias() const;

    /// Rms of what all images together err beyond their noise, as a part of the mean.
    double excess() const;

    /// Rms error, as a part of the mean, that is found at a level of 1e-4 with a power of 99.9 %.
    double detectable() const;

    /// Whether right code would show it with a probability of at most `level`: an error that all
    /// images have in common, or that is larger than their noise.
    bool rejects(double level) const;

    /// Means that scatter more than their samples, or hardly at all, come from numbers used again;
    /// an error that is just there leaves them as they must be.
    bool isReused() const;

    /// All of it in sentences.
    std::string describe() const;
};

constexpr int kNoiseRepeats = 64;

/// Asks for the images of the template `box`, filled anew for each context.
ImageNoise measureNoise(CheckContext &context, int stage);

/// The three channels of each place together.
std::vector<statistics::MomentSummary> interleaved(const RadianceSamples &samples);

/// `1.043 (99.9 %: 0.829 to 1.139)`
std::string describe(const statistics::RatioEstimate &ratio);

} // namespace grader
