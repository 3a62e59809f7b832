// SPDX-License-Identifier: MIT
#include "mean_tests.h"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace statistics {

namespace {

using StudentLaw = boost::math::students_t;

double twoSidedP(double t, double degreesOfFreedom) {
    return std::min(1.0, 2.0 * cdf(complement(StudentLaw(degreesOfFreedom), std::fabs(t))));
}

void requireTwo(const MomentSummary &sample, const char *message) {
    if (!(sample.count >= 2.0)) {
        throw std::invalid_argument(message);
    }
}

double square(double x) {
    return x * x;
}

} // namespace

double hallTransform(double z, double meanSkewness) {
    const double g = meanSkewness;
    return z + g * z * z / 3.0 + g * g * z * z * z / 27.0 + g / 6.0;
}

MeanTestResult meanTest(double difference, double variance, double thirdCentral,
                        double degreesOfFreedom) {
    MeanTestResult result;
    result.difference = difference;
    result.degreesOfFreedom = degreesOfFreedom;
    if (!(variance > 0.0)) {
        result.pValue = result.pValuePlain = difference == 0.0 ? 1.0 : 0.0;
        return result;
    }
    result.standardError = std::sqrt(variance);
    result.meanSkewness = thirdCentral / std::pow(variance, 1.5);
    result.z = difference / result.standardError;
    result.hall = hallTransform(result.z, result.meanSkewness);
    result.pValuePlain = twoSidedP(result.z, degreesOfFreedom);
    result.pValue = twoSidedP(result.hall, degreesOfFreedom);
    result.gateMet = std::fabs(result.meanSkewness) <= kSkewnessGate;
    return result;
}

MeanTestResult oneSampleTest(const MomentSummary &sample, double target) {
    requireTwo(sample, "oneSampleTest: needs at least 2 samples");
    return meanTest(sample.mean - target, sample.variance / sample.count,
                    sample.thirdCentral / square(sample.count), sample.count - 1.0);
}

MeanTestResult welchTest(const MomentSummary &a, const MomentSummary &b) {
    requireTwo(a, "welchTest: needs at least 2 samples in the first group");
    requireTwo(b, "welchTest: needs at least 2 samples in the second group");
    const double va = a.variance / a.count;
    const double vb = b.variance / b.count;
    const double denominator = square(va) / (a.count - 1.0) + square(vb) / (b.count - 1.0);
    const double degreesOfFreedom =
        denominator > 0.0 ? square(va + vb) / denominator : a.count + b.count - 2.0;
    return meanTest(a.mean - b.mean, va + vb,
                    a.thirdCentral / square(a.count) - b.thirdCentral / square(b.count),
                    degreesOfFreedom);
}

double absoluteDifferenceBound(const MeanTestResult &test, double level) {
    if (test.standardError == 0.0) {
        return std::fabs(test.difference);
    }
    const double q = quantile(complement(StudentLaw(test.degreesOfFreedom), level / 2.0));
    return std::fabs(test.difference) + q * test.standardError;
}

double detectableDifference(double standardError, double significance, double power) {
    const boost::math::normal law;
    return standardError * (quantile(complement(law, significance / 2.0)) + quantile(law, power));
}

} // namespace statistics
