// SPDX-License-Identifier: MIT
#include "replicates.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace statistics {

namespace {

void requireShape(bool right, const char *function) {
    if (!right) {
        throw std::invalid_argument(std::string(function) +
                                    ": needs at least 2 of each, and shapes that agree");
    }
}

} // namespace

bool RatioEstimate::differsFromOne(double tolerance, double deviations) const {
    return std::fabs(ratio - 1.0) - deviations * standardError > tolerance;
}

RatioEstimate ratioOfSums(std::span<const double> numerators, std::span<const double> denominators,
                          std::size_t channels) {
    requireShape(channels > 0 && numerators.size() == denominators.size() &&
                     numerators.size() >= 2 * channels && numerators.size() % channels == 0,
                 "ratioOfSums");
    double numerator = 0.0;
    double denominator = 0.0;
    for (std::size_t i = 0; i < numerators.size(); ++i) {
        numerator += numerators[i];
        denominator += denominators[i];
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
            residual += numerators[c] - result.ratio * denominators[c];
        }
        squares += residual * residual;
    }
    result.standardError = std::sqrt(squares) / denominator;
    return result;
}

RatioEstimate betweenWithinRatio(const std::vector<std::vector<MomentSummary>> &replicates,
                                 std::size_t channels) {
    requireShape(replicates.size() >= 2 && replicates[0].size() >= 2, "betweenWithinRatio");
    const std::size_t places = replicates[0].size();
    std::vector<double> between;
    std::vector<double> within;
    for (std::size_t i = 0; i < places; ++i) {
        RunningMoments means;
        double variance = 0.0;
        double count = 0.0;
        for (const std::vector<MomentSummary> &replicate : replicates) {
            requireShape(replicate.size() == places, "betweenWithinRatio");
            means.add(replicate[i].mean);
            variance += replicate[i].variance;
            count += replicate[i].count;
        }
        const auto number = static_cast<double>(replicates.size());
        between.push_back(means.summary().variance * count / number);
        within.push_back(variance / number);
    }
    return ratioOfSums(between, within, channels);
}

RatioEstimate errorVarianceRatio(std::span<const MomentSummary> image,
                                 std::span<const MomentSummary> reference, std::size_t channels) {
    requireShape(image.size() == reference.size(), "errorVarianceRatio");
    std::vector<double> errors;
    std::vector<double> variances;
    for (std::size_t i = 0; i < image.size(); ++i) {
        const double difference = image[i].mean - reference[i].mean;
        errors.push_back(difference * difference);
        variances.push_back(image[i].variance / image[i].count +
                            reference[i].variance / reference[i].count);
    }
    return ratioOfSums(errors, variances, channels);
}

RatioEstimate varianceRatio(std::span<const MomentSummary> image,
                            std::span<const MomentSummary> reference, std::size_t channels) {
    requireShape(image.size() == reference.size(), "varianceRatio");
    std::vector<double> numerators;
    std::vector<double> denominators;
    for (std::size_t i = 0; i < image.size(); ++i) {
        numerators.push_back(image[i].variance);
        denominators.push_back(reference[i].variance);
    }
    return ratioOfSums(numerators, denominators, channels);
}

} // namespace statistics
