// SPDX-License-Identifier: MIT
#include "chi_square.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>

#include <cmath>
#include <stdexcept>
#include <string>

namespace statistics {

namespace {

using CentralLaw = boost::math::chi_squared;
using NoncentralLaw = boost::math::non_central_chi_squared;

void requireCounts(std::span<const double> counts, const char *name) {
    if (counts.empty()) {
        throw std::invalid_argument(std::string("chiSquareTest: ") + name + " is empty");
    }
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (!std::isfinite(counts[i]) || counts[i] < 0.0) {
            throw std::invalid_argument(std::string("chiSquareTest: ") + name + "[" +
                                        std::to_string(i) + "] = " + std::to_string(counts[i]) +
                                        ", must be finite and >= 0");
        }
    }
}

double centralPValue(double statistic, int degreesOfFreedom) {
    if (degreesOfFreedom <= 0) {
        return 1.0;
    }
    return cdf(complement(CentralLaw(degreesOfFreedom), statistic));
}

void requirePositive(double sampleCount, int degreesOfFreedom, const char *function) {
    if (!(sampleCount > 0.0) || degreesOfFreedom <= 0) {
        throw std::invalid_argument(std::string(function) +
                                    ": needs samples and at least 1 degree of freedom");
    }
}

} // namespace

ChiSquareResult chiSquareTest(std::span<const double> observed, std::span<const double> expected,
                              const ChiSquareConfig &config) {
    requireCounts(observed, "observed");
    requireCounts(expected, "expected");
    if (observed.size() != expected.size()) {
        throw std::invalid_argument("chiSquareTest: " + std::to_string(observed.size()) +
                                    " observed cells, but " + std::to_string(expected.size()) +
                                    " expected ones");
    }

    struct Group {
        double observed = 0.0;
        double expected = 0.0;

        [[nodiscard]] double term() const {
            return expected > 0.0 ? (observed - expected) * (observed - expected) / expected : 0.0;
        }
    };

    ChiSquareResult result;
    Group closed; // the last complete group: it takes what is left over at the end
    Group open;
    int groups = 0;
    for (std::size_t i = 0; i < observed.size(); ++i) {
        if (expected[i] == 0.0) {
            result.impossibleHits += observed[i];
            continue;
        }
        open.observed += observed[i];
        open.expected += expected[i];
        if (open.expected >= config.minExpected) {
            result.statistic += closed.term();
            closed = open;
            open = {};
            ++groups;
        }
    }
    closed.observed += open.observed;
    closed.expected += open.expected;
    result.statistic += closed.term();
    result.degreesOfFreedom = groups > 0 ? groups - 1 : 0;
    result.pValue = result.impossibleHits > 0.0
                        ? 0.0
                        : centralPValue(result.statistic, result.degreesOfFreedom);
    return result;
}

ChiSquareResult chiSquareEqualCells(std::span<const double> observed, double sampleCount) {
    requireCounts(observed, "observed");
    if (!std::isfinite(sampleCount) || sampleCount <= 0.0) {
        throw std::invalid_argument(
            "chiSquareEqualCells: sampleCount = " + std::to_string(sampleCount) + ", must be > 0");
    }
    const double expected = sampleCount / static_cast<double>(observed.size());
    ChiSquareResult result;
    for (const double count : observed) {
        result.statistic += (count - expected) * (count - expected) / expected;
    }
    result.degreesOfFreedom = static_cast<int>(observed.size()) - 1;
    result.pValue = centralPValue(result.statistic, result.degreesOfFreedom);
    return result;
}

double toleranceZonePValue(double statistic, int degreesOfFreedom, double sampleCount,
                           double tolerance) {
    requirePositive(sampleCount, degreesOfFreedom, "toleranceZonePValue");
    const double noncentrality = sampleCount * tolerance * tolerance;
    if (noncentrality == 0.0) {
        return centralPValue(statistic, degreesOfFreedom);
    }
    // Beyond 60 standard deviations the series of the noncentral law no longer converges in
    // reasonable time, and the answer is 0 to every purpose.
    const double mean = degreesOfFreedom + noncentrality;
    const double deviation = std::sqrt(2.0 * (degreesOfFreedom + 2.0 * noncentrality));
    if (statistic > mean + 60.0 * deviation) {
        return 0.0;
    }
    return cdf(complement(NoncentralLaw(degreesOfFreedom, noncentrality), statistic));
}

double toleranceZoneDensity(double statistic, int degreesOfFreedom, double sampleCount,
                            double tolerance) {
    requirePositive(sampleCount, degreesOfFreedom, "toleranceZoneDensity");
    const double noncentrality = sampleCount * tolerance * tolerance;
    return noncentrality > 0.0
               ? boost::math::pdf(NoncentralLaw(degreesOfFreedom, noncentrality), statistic)
               : boost::math::pdf(CentralLaw(degreesOfFreedom), statistic);
}

double toleranceZoneCritical(double level, int degreesOfFreedom, double sampleCount,
                             double tolerance) {
    requirePositive(sampleCount, degreesOfFreedom, "toleranceZoneCritical");
    const double noncentrality = sampleCount * tolerance * tolerance;
    return noncentrality > 0.0 ? boost::math::quantile(boost::math::complement(
                                     NoncentralLaw(degreesOfFreedom, noncentrality), level))
                               : boost::math::quantile(
                                     boost::math::complement(CentralLaw(degreesOfFreedom), level));
}

double rmsErrorEstimate(double statistic, int degreesOfFreedom, double sampleCount) {
    requirePositive(sampleCount, degreesOfFreedom, "rmsErrorEstimate");
    return std::sqrt(std::fmax(0.0, statistic - degreesOfFreedom) / sampleCount);
}

double rmsErrorUpperBound(double statistic, int degreesOfFreedom, double sampleCount,
                          double level) {
    requirePositive(sampleCount, degreesOfFreedom, "rmsErrorUpperBound");
    // Even noncentrality 0 gives so small a statistic with less than this probability: bound 0.
    if (cdf(CentralLaw(degreesOfFreedom), statistic) <= level) {
        return 0.0;
    }
    // For a gross error sqrt(X^2) is normal with variance 1 to many digits, and Boost's search for
    // the root is slow there. Leaving out the degrees of freedom errs to the safe side.
    if (statistic > 1e5) {
        const double z = quantile(complement(boost::math::normal(), level));
        return (std::sqrt(statistic) + z) / std::sqrt(sampleCount);
    }
    const double noncentrality =
        NoncentralLaw::find_non_centrality(degreesOfFreedom, statistic, level);
    return std::sqrt(noncentrality / sampleCount);
}

double rmsErrorDetectable(int degreesOfFreedom, double sampleCount,
                          const DetectableErrorConfig &config) {
    requirePositive(sampleCount, degreesOfFreedom, "rmsErrorDetectable");
    const double critical =
        toleranceZoneCritical(config.significance, degreesOfFreedom, sampleCount, config.tolerance);
    return std::sqrt(
        NoncentralLaw::find_non_centrality(degreesOfFreedom, critical, 1.0 - config.power) /
        sampleCount);
}

} // namespace statistics
