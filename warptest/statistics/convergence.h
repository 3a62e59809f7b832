// SPDX-License-Identifier: MIT
#pragma once

#include <statistics/moments.h>

#include <cstddef>
#include <span>
#include <vector>

namespace statistics {

/// Mean squared error of an image against a reference of which there are two independent halves:
/// the weighted mean of (X - A)(X - B), whose expectation does not hold the reference's noise. Each
/// pixel counts by the inverse of its variance as the reference knows it (plus a tenth of the mean
/// one), so that no few pixels decide; pixels without noise do not count. In units of that
/// variance: for right code 1 / samples.
///
/// Shapes: [pixels] of one channel, the same for all three.
/// \throws std::invalid_argument  if they differ, or no pixel of `a` has noise
double debiasedError(std::span<const MomentSummary> image, std::span<const MomentSummary> a,
                     std::span<const MomentSummary> b);

/// Standard error of what the noise of the reference itself adds to every debiasedError() against
/// these halves, in its units. Its expectation is 0, but all images share one value of it, which
/// the replicates' scatter therefore does not show. Matters where the reference is noisier than the
/// images: `direct_mis` against a reference by `direct_ems`.
///
/// \param channels  values of one place, which may depend on each other, stand in runs of this many
/// \throws std::invalid_argument  if the shapes differ, or no pixel of `a` has noise
double commonError(std::span<const MomentSummary> a, std::span<const MomentSummary> b,
                   std::size_t channels = 1);

/// Errors of independent replicates with one number of samples.
struct ErrorsAt {
    double samples = 0.0;       ///< per pixel
    std::vector<double> errors; ///< mean squared, of each replicate
};

struct ErrorPoint {
    double samples = 0.0;
    double rmse = 0.0; ///< root of the replicates' mean
    double low = 0.0;  ///< 95 % confidence interval, from the replicates' scatter and the reference
    double high = 0.0;
};

/// How the error falls with the number of samples.
struct ConvergenceFit {
    std::vector<ErrorPoint> points;
    double slope = 0.0; ///< of log RMSE over log samples; -1/2 for an unbiased estimator
    double standardError = 0.0;
    double low = 0.0; ///< confidence interval of `slope`
    double high = 0.0;

    /// Whether the interval contains -1/2 and lies within 0.06 of it.
    [[nodiscard]] bool isMonteCarlo() const;

    /// Whether the interval leaves -1/2 out.
    [[nodiscard]] bool isOtherwise() const;
};

/// Fits a line by least squares. Its error comes from the replicates' relative scatter, pooled over
/// the numbers of samples: there it is the same, up to the samples' kurtosis.
///
/// \param level   of the interval, two-sided: 1 - its confidence
/// \param common  commonError() of the reference
/// \throws std::invalid_argument  below 2 numbers of samples or 2 replicates, or when a mean error
///                                is not above 0: the reference is too noisy to tell it
ConvergenceFit fitConvergence(std::span<const ErrorsAt> errors, double level = 1e-4,
                              double common = 0.0);

} // namespace statistics
