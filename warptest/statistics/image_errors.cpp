// SPDX-License-Identifier: MIT
#include "image_errors.h"

#include <statistics/moments.h>

#include <boost/math/distributions/normal.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace statistics {

ImageErrors imageErrors(std::span<const float> image, std::span<const float> reference) {
    if (image.empty() || image.size() != reference.size())
        throw std::invalid_argument("imageErrors: images must have one size, and pixels");
    const auto count = static_cast<double>(image.size());
    ImageErrors errors;
    for (std::size_t i = 0; i < image.size(); ++i) {
        errors.mean += double{image[i]} / count;
        errors.referenceMean += double{reference[i]} / count;
    }
    // A black reference leaves nothing to relate to; the smallest number keeps 0 / 0 at 0.
    const double unit = std::max(std::fabs(errors.referenceMean), 1e-300);
    double squares = 0.0;
    for (std::size_t i = 0; i < image.size(); ++i) {
        const double x{image[i]};
        const double r{reference[i]};
        const double difference = std::fabs(x - r);
        squares += difference * difference;
        errors.relMse += difference * difference / std::max(r * r + 1e-2 * unit * unit, 1e-300);
        errors.smape += 2.0 * difference / (std::fabs(x) + std::fabs(r) + 1e-3 * unit);
        errors.largest = std::max(errors.largest, difference);
    }
    errors.rmse = std::sqrt(squares / count);
    errors.relMse /= count;
    errors.smape /= count;
    return errors;
}

NoiseTest noiseTest(std::span<const double> differences, std::span<const double> variances) {
    if (differences.size() < 2 || differences.size() != variances.size())
        throw std::invalid_argument("noiseTest: one variance for each of at least 2 differences");
    RunningMoments excess;
    RunningMoments expected;
    for (std::size_t i = 0; i < differences.size(); ++i) {
        excess.add(differences[i] * differences[i] - variances[i]);
        expected.add(variances[i]);
    }
    const MomentSummary summary = excess.summary();
    const double mean = expected.summary().mean;
    NoiseTest test;
    if (mean > 0.0)
        test.ratio = 1.0 + summary.mean / mean;
    if (summary.variance > 0.0)
        test.z = summary.mean / std::sqrt(summary.variance / summary.count);
    test.pValue = 2.0 * cdf(complement(boost::math::normal(), std::fabs(test.z)));
    return test;
}

} // namespace statistics
