// SPDX-License-Identifier: MIT
#include "convergence.h"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace statistics {

namespace {

constexpr double kSlope = -0.5;
constexpr double kTolerance = 0.06;

struct Scatter {
    double mean = 0.0;
    double relativeVariance = 0.0; ///< of one replicate
};

Scatter scatterOf(const ErrorsAt &at) {
    RunningMoments moments;
    for (const double error : at.errors)
        moments.add(error);
    const MomentSummary summary = moments.summary();
    if (summary.count < 2)
        throw std::invalid_argument("fitConvergence: at least 2 replicates are needed");
    if (!(summary.mean > 0.0))
        throw std::invalid_argument("fitConvergence: the reference is too noisy for this error");
    return {summary.mean, summary.variance / (summary.mean * summary.mean)};
}

/// Added to each place's variance, so that places which are hardly noisy do not outweigh the rest.
double weightFloor(std::span<const MomentSummary> reference) {
    double mean = 0.0;
    for (const MomentSummary &pixel : reference)
        mean += pixel.variance / static_cast<double>(reference.size());
    return 0.1 * mean;
}

} // namespace

double debiasedError(std::span<const MomentSummary> image, std::span<const MomentSummary> a,
                     std::span<const MomentSummary> b) {
    if (image.size() != a.size() || image.size() != b.size())
        throw std::invalid_argument("debiasedError: images of one size are needed");
    const double floor = weightFloor(a);
    double sum = 0.0;
    double expected = 0.0;
    for (std::size_t i = 0; i < image.size(); ++i) {
        if (!(a[i].variance > 0.0))
            continue;
        const double weight = 1.0 / (a[i].variance + floor);
        sum += weight * (image[i].mean - a[i].mean) * (image[i].mean - b[i].mean);
        expected += weight * a[i].variance;
    }
    if (!(expected > 0.0))
        throw std::invalid_argument("debiasedError: the reference shows no noise");
    return sum / expected;
}

double commonError(std::span<const MomentSummary> a, std::span<const MomentSummary> b,
                   std::size_t channels) {
    if (a.size() != b.size() || channels == 0 || a.size() % channels != 0)
        throw std::invalid_argument("commonError: images of one size are needed");
    const double floor = weightFloor(a);
    double variance = 0.0;
    double expected = 0.0;
    for (std::size_t begin = 0; begin < a.size(); begin += channels) {
        double deviation = 0.0;
        for (std::size_t i = begin; i < begin + channels; ++i) {
            if (!(a[i].variance > 0.0) || !(a[i].count > 0.0) || !(b[i].count > 0.0))
                continue;
            const double weight = 1.0 / (a[i].variance + floor);
            deviation +=
                weight * std::sqrt(a[i].variance / a[i].count * b[i].variance / b[i].count);
            expected += weight * a[i].variance;
        }
        variance += deviation * deviation;
    }
    if (!(expected > 0.0))
        throw std::invalid_argument("commonError: the reference shows no noise");
    return std::sqrt(variance) / expected;
}

bool ConvergenceFit::isMonteCarlo() const {
    return low <= kSlope && kSlope <= high && low >= kSlope - kTolerance &&
           high <= kSlope + kTolerance;
}

bool ConvergenceFit::isOtherwise() const {
    return kSlope < low || high < kSlope;
}

ConvergenceFit fitConvergence(std::span<const ErrorsAt> errors, double level, double common) {
    if (errors.size() < 2)
        throw std::invalid_argument("fitConvergence: at least 2 numbers of samples are needed");
    const auto count = static_cast<double>(errors.size());
    const double narrow = quantile(complement(boost::math::normal(), 0.025));
    ConvergenceFit fit;
    double meanX = 0.0;
    double meanY = 0.0;
    double logVariance = 0.0; ///< of a point's log RMSE, pooled
    double degreesOfFreedom = 0.0;
    for (const ErrorsAt &at : errors) {
        const Scatter scatter = scatterOf(at);
        const auto replicates = static_cast<double>(at.errors.size());
        const double relative = scatter.relativeVariance / replicates;
        const double rmse = std::sqrt(scatter.mean);
        const double deviation = std::hypot(std::sqrt(relative), common / scatter.mean);
        const double factor = std::exp(0.5 * narrow * deviation);
        fit.points.push_back({at.samples, rmse, rmse / factor, rmse * factor});
        meanX += std::log(at.samples) / count;
        meanY += std::log(rmse) / count;
        logVariance += 0.25 * relative / count;
        degreesOfFreedom += replicates - 1.0;
    }
    double sxx = 0.0;
    double sxy = 0.0;
    for (const ErrorPoint &point : fit.points) {
        const double x = std::log(point.samples) - meanX;
        sxx += x * x;
        sxy += x * (std::log(point.rmse) - meanY);
    }
    if (!(sxx > 0.0))
        throw std::invalid_argument("fitConvergence: at least 2 numbers of samples are needed");
    fit.slope = sxy / sxx;
    // One and the same for all points, so it moves them together: its influences add up.
    double shared = 0.0;
    for (const ErrorPoint &point : fit.points) {
        const double relative = 0.5 * common / (point.rmse * point.rmse);
        shared += (std::log(point.samples) - meanX) / sxx * relative;
    }
    fit.standardError = std::sqrt(logVariance / sxx + shared * shared);
    const double wide =
        quantile(complement(boost::math::students_t(degreesOfFreedom), 0.5 * level));
    fit.low = fit.slope - wide * fit.standardError;
    fit.high = fit.slope + wide * fit.standardError;
    return fit;
}

} // namespace statistics
