// SPDX-License-Identifier: MIT
#pragma once

#include <statistics/moments.h>

#include <cstddef>
#include <span>
#include <vector>

namespace statistics {

/// A ratio of two sums over independent places. For people: with the heavy tails of squares, its
/// interval is too narrow by a half (measured: 99 % intervals miss in up to 6 % of the runs).
struct RatioEstimate {
    double ratio = 1.0;
    double standardError = 0.0;
};

/// How the places of a ratio go together.
struct RatioPlaces {
    /// Values of one place, which may depend on each other, stand in runs of this many.
    std::size_t channels = 1;
    /// One per value, or none for equal ones. They must not depend on the data.
    std::span<const double> weights = {};
};

/// Weights that keep a few noisy places from being all that counts: one over the variance plus the
/// mean variance.
std::vector<double> noiseWeights(std::span<const MomentSummary> reference);

/// sum numerators / sum denominators. Errors come from the places themselves, so that nothing is
/// assumed of the law of a sample. 1 +- 0 where all are 0.
/// \throws std::invalid_argument  if the shapes differ or there are less than 2 places
RatioEstimate ratioOfSums(std::span<const double> numerators, std::span<const double> denominators,
                          const RatioPlaces &places = {});

/// What two images of one program have in common beyond what they should show.
struct CommonError {
    double meanSquare = 0.0;    ///< estimate of the mean squared bias; may be negative
    double standardError = 0.0; ///< of `meanSquare`
    double pValue = 1.0;        ///< two-sided, of its being 0; at least 2^-20
};

/// Two images of a program, and one for each of what they should show.
struct ImagePair {
    std::span<const MomentSummary> a, referenceA, b, referenceB;
};

/// mean (a - referenceA) (b - referenceB): the mean squared bias, without a noise floor and without
/// an estimate of variance. Independent images that are right give products of independent numbers
/// about 0, whose signs signFlipPValue() tests whatever the law of the samples. Images that use the
/// same random numbers have their noise in common. Channels of a place and `pairs` are summed up.
/// \throws std::invalid_argument  if the shapes differ or there are less than 2 places
CommonError commonError(std::span<const ImagePair> pairs, const RatioPlaces &places = {});

/// The variance of replicates' means, times the samples in each, over the variance of samples
/// within them. 1: independent samples. More: random numbers are used again, so that the samples of
/// one replicate are alike. Less: stratified samples, or replicates that are alike.
///
/// \param replicates  shape [replicates][places * channels], the same count everywhere
/// \throws std::invalid_argument  if the shapes differ, or below 2 replicates or places
RatioEstimate betweenWithinRatio(const std::vector<std::vector<MomentSummary>> &replicates,
                                 const RatioPlaces &places = {});

/// Squared difference of two images over what their samples' variances predict: 1 if both are
/// right and made of independent samples. More: an error, or samples used again. Less: one was
/// made from the other, or smoothed.
/// \throws std::invalid_argument  if the shapes differ or there are less than 2 places
RatioEstimate errorVarianceRatio(std::span<const MomentSummary> image,
                                 std::span<const MomentSummary> reference,
                                 const RatioPlaces &places = {});

/// Whether the squared error of an image is what its noise says: two-sided p-value.
///
/// An image of samples of the same law as `right`'s errs from the reference as much, so that the
/// differences of their squared errors are symmetric about 0, whatever that law: signFlipPValue().
/// Another right estimator has other noise; `right`'s squares are scaled by what the variances of
/// both promise.
/// \param right      of as many samples as `image`
/// \param reference  independent of both
/// \throws std::invalid_argument  if the shapes differ or there are less than 2 places
double errorPValue(std::span<const MomentSummary> image, std::span<const MomentSummary> right,
                   std::span<const MomentSummary> reference, const RatioPlaces &places = {});

/// Variance of one sample, of one image over another's, both summed over the places.
/// \throws std::invalid_argument  if the shapes differ or there are less than 2 places
RatioEstimate varianceRatio(std::span<const MomentSummary> image,
                            std::span<const MomentSummary> reference,
                            const RatioPlaces &places = {});

} // namespace statistics
