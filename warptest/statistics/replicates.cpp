// SPDX-License-Identifier: MIT
#include "replicates.h"

#include <statistics/sign_flips.h>

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace statistics {

namespace {

/// The products are new each time; the signs that they are given need not be.
constexpr std::uint64_t kSignSeed = 1;

void requireShape(bool right, const char *function) {
    if (!right) {
        throw std::invalid_argument(std::string(function) +
                                    ": needs at least 2 of each, and shapes that agree");
    }
}

} // namespace

std::vector<double> noiseWeights(std::span<const MomentSummary> reference) {
    double mean = 0.0;
    for (const MomentSummary &place : reference) {
        mean += place.variance / static_cast<double>(reference.size());
    }
    std::vector<double> weights;
    for (const MomentSummary &place : reference) {
        weights.push_back(mean > 0.0 ? mean / (place.variance + mean) : 1.0);
    }
    return weights;
}

RatioEstimate ratioOfSums(std::span<const double> numerators, std::span<const double> denominators,
                          const RatioPlaces &places) {
    const std::size_t channels = places.channels;
    requireShape(channels > 0 && numerators.size() == denominators.size() &&
                     numerators.size() >= 2 * channels && numerators.size() % channels == 0 &&
                     (places.weights.empty() || places.weights.size() == numerators.size()),
                 "ratioOfSums");
    const auto weight = [&](std::size_t i) {
        return places.weights.empty() ? 1.0 : places.weights[i];
    };
    double numerator = 0.0;
    double denominator = 0.0;
    for (std::size_t i = 0; i < numerators.size(); ++i) {
        numerator += weight(i) * numerators[i];
        denominator += weight(i) * denominators[i];
    }
    RatioEstimate result;
    if (numerator == 0.0 && denominator == 0.0) {
        return result;
    }
    result.ratio = numerator / denominator;
    if (!std::isfinite(result.ratio)) {
        return result;
    }
    double squares = 0.0;
    for (std::size_t i = 0; i < numerators.size(); i += channels) {
        double residual = 0.0;
        for (std::size_t c = i; c < i + channels; ++c) {
            residual += weight(c) * (numerators[c] - result.ratio * denominators[c]);
        }
        squares += residual * residual;
    }
    result.standardError = std::sqrt(squares) / denominator;
    return result;
}

CommonError commonError(std::span<const ImagePair> pairs, const RatioPlaces &places) {
    requireShape(!pairs.empty() && places.channels > 0, "commonError");
    const std::size_t values = pairs[0].a.size();
    requireShape(values >= 2 * places.channels && values % places.channels == 0 &&
                     (places.weights.empty() || places.weights.size() == values),
                 "commonError");
    std::vector<double> products;
    RunningMoments moments;
    for (std::size_t i = 0; i < values; i += places.channels) {
        double sum = 0.0;
        double weights = 0.0;
        for (const ImagePair &pair : pairs) {
            requireShape(pair.a.size() == values && pair.b.size() == values &&
                             pair.referenceA.size() == values && pair.referenceB.size() == values,
                         "commonError");
            for (std::size_t c = i; c < i + places.channels; ++c) {
                const double weight = places.weights.empty() ? 1.0 : places.weights[c];
                sum += weight * (pair.a[c].mean - pair.referenceA[c].mean) *
                       (pair.b[c].mean - pair.referenceB[c].mean);
                weights += weight;
            }
        }
        products.push_back(weights > 0.0 ? sum / weights : 0.0);
        moments.add(products.back());
    }
    const MomentSummary summary = moments.summary();
    return {summary.mean, std::sqrt(summary.variance / summary.count),
            signFlipPValue(products, kSignSeed)};
}

RatioEstimate betweenWithinRatio(const std::vector<std::vector<MomentSummary>> &replicates,
                                 const RatioPlaces &places) {
    requireShape(replicates.size() >= 2 && replicates[0].size() >= 2, "betweenWithinRatio");
    const std::size_t values = replicates[0].size();
    std::vector<double> between;
    std::vector<double> within;
    for (std::size_t i = 0; i < values; ++i) {
        RunningMoments means;
        double variance = 0.0;
        double count = 0.0;
        for (const std::vector<MomentSummary> &replicate : replicates) {
            requireShape(replicate.size() == values, "betweenWithinRatio");
            means.add(replicate[i].mean);
            variance += replicate[i].variance;
            count += replicate[i].count;
        }
        const auto number = static_cast<double>(replicates.size());
        between.push_back(means.summary().variance * count / number);
        within.push_back(variance / number);
    }
    return ratioOfSums(between, within, places);
}

RatioEstimate errorVarianceRatio(std::span<const MomentSummary> image,
                                 std::span<const MomentSummary> reference,
                                 const RatioPlaces &places) {
    requireShape(image.size() == reference.size(), "errorVarianceRatio");
    std::vector<double> errors;
    std::vector<double> variances;
    for (std::size_t i = 0; i < image.size(); ++i) {
        const double difference = image[i].mean - reference[i].mean;
        errors.push_back(difference * difference);
        variances.push_back(image[i].variance / image[i].count +
                            reference[i].variance / reference[i].count);
    }
    return ratioOfSums(errors, variances, places);
}

double errorPValue(std::span<const MomentSummary> image, std::span<const MomentSummary> right,
                   std::span<const MomentSummary> reference, const RatioPlaces &places) {
    const std::size_t values = image.size();
    requireShape(right.size() == values && reference.size() == values && places.channels > 0 &&
                     values >= 2 * places.channels && values % places.channels == 0 &&
                     (places.weights.empty() || places.weights.size() == values),
                 "errorPValue");
    const auto weight = [&](std::size_t i) {
        return places.weights.empty() ? 1.0 : places.weights[i];
    };
    double promised = 0.0;
    double promisedRight = 0.0;
    for (std::size_t i = 0; i < values; ++i) {
        const double common = reference[i].variance / reference[i].count;
        promised += weight(i) * (image[i].variance / image[i].count + common);
        promisedRight += weight(i) * (right[i].variance / right[i].count + common);
    }
    const double scale = promisedRight > 0.0 ? promised / promisedRight : 1.0;
    std::vector<double> differences;
    for (std::size_t i = 0; i < values; i += places.channels) {
        double sum = 0.0;
        for (std::size_t c = i; c < i + places.channels; ++c) {
            const double own = image[c].mean - reference[c].mean;
            const double other = right[c].mean - reference[c].mean;
            sum += weight(c) * (own * own - scale * other * other);
        }
        differences.push_back(sum);
    }
    return signFlipPValue(differences, kSignSeed);
}

RatioEstimate varianceRatio(std::span<const MomentSummary> image,
                            std::span<const MomentSummary> reference, const RatioPlaces &places) {
    requireShape(image.size() == reference.size(), "varianceRatio");
    std::vector<double> numerators;
    std::vector<double> denominators;
    for (std::size_t i = 0; i < image.size(); ++i) {
        numerators.push_back(image[i].variance);
        denominators.push_back(reference[i].variance);
    }
    return ratioOfSums(numerators, denominators, places);
}

} // namespace statistics
