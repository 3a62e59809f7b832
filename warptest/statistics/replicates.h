// SPDX-License-Identifier: MIT
#pragma once

#include <statistics/moments.h>

#include <cstddef>
#include <span>
#include <vector>

namespace statistics {

/// A ratio of two sums over independent places, with its standard error.
struct RatioEstimate {
    double ratio = 1.0;
    double standardError = 0.0;

    /// \return  whether the ratio is more than `tolerance` away from 1, beyond `deviations`
    ///          standard errors
    [[nodiscard]] bool differsFromOne(double tolerance, double deviations) const;
};

/// sum numerators / sum denominators. The error comes from the places themselves (delta method), so
/// it needs no assumption on the law of a sample. 1 +- 0 where both sums are 0.
///
/// \param channels  values of one place, which may depend on each other, stand in runs of this many
/// \throws std::invalid_argument  if the shapes differ or there are less than 2 places
RatioEstimate ratioOfSums(std::span<const double> numerators, std::span<const double> denominators,
                          std::size_t channels = 1);

/// The variance of replicates' means, times the samples in each, over the variance of samples
/// within them. 1: independent samples. More: random numbers are used again, so that the samples of
/// one replicate are alike. Less: stratified samples, or replicates that are alike.
///
/// \param replicates  shape [replicates][places * channels], the same count everywhere
/// \throws std::invalid_argument  if the shapes differ, or below 2 replicates or places
RatioEstimate betweenWithinRatio(const std::vector<std::vector<MomentSummary>> &replicates,
                                 std::size_t channels = 1);

/// Squared difference of two images over what their samples' variances predict: 1 if both are
/// right and made of independent samples. More: an error, or samples used again. Less: one was
/// made from the other, or smoothed.
/// \throws std::invalid_argument  if the shapes differ or there are less than 2 places
RatioEstimate errorVarianceRatio(std::span<const MomentSummary> image,
                                 std::span<const MomentSummary> reference,
                                 std::size_t channels = 1);

/// Variance of one sample, of one image over another's, both summed over the places.
/// \throws std::invalid_argument  if the shapes differ or there are less than 2 places
RatioEstimate varianceRatio(std::span<const MomentSummary> image,
                            std::span<const MomentSummary> reference, std::size_t channels = 1);

} // namespace statistics
