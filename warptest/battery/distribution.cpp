// SPDX-License-Identifier: MIT
#include "distribution.h"

#include <battery/unit_square.h>
#include <statistics/chi_square.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace battery {

namespace {

struct Shape {
    int uBins;
    int vBins;
};

constexpr std::array<Shape, 4> kShapes{{{32, 32}, {8, 8}, {256, 1}, {1, 256}}};

HistogramTest testHistogram(const catalog::WarpEntry &entry, double a, const Shape &shape,
                            std::span<const double> counts, double total) {
    const statistics::ChiSquareResult plain = statistics::chiSquareEqualCells(counts, total);
    HistogramTest test{.uBins = shape.uBins,
                       .vBins = shape.vBins,
                       .statistic = plain.statistic,
                       .degreesOfFreedom = plain.degreesOfFreedom};
    test.tolerance = catalog::distributionTolerance(entry, a, shape.uBins);
    test.pValue = statistics::toleranceZonePValue(test.statistic, test.degreesOfFreedom, total,
                                                  test.tolerance);
    test.rmsError = statistics::rmsErrorEstimate(test.statistic, test.degreesOfFreedom, total);
    test.rmsBound = statistics::rmsErrorUpperBound(test.statistic, test.degreesOfFreedom, total);
    test.mde =
        statistics::rmsErrorDetectable(test.degreesOfFreedom, total, {.tolerance = test.tolerance});
    return test;
}

/// Distance of a statistic from the mean of its null law, in standard deviations.
double standardised(const HistogramTest &test, double total) {
    const double noncentrality = total * test.tolerance * test.tolerance;
    return (test.statistic - test.degreesOfFreedom - noncentrality) /
           std::sqrt(2.0 * (test.degreesOfFreedom + 2.0 * noncentrality));
}

void locateWorstCell(std::span<const double> counts, double expected, DistributionResult &result) {
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double relative = counts[i] / expected - 1.0;
        if (std::fabs(relative) > std::fabs(result.worstRelative)) {
            result.worstRelative = relative;
            result.worstU = static_cast<int>(i) / 8;
            result.worstV = static_cast<int>(i) % 8;
        }
    }
}

double passLimit(const catalog::WarpEntry &entry, double a) {
    return std::max(kDistributionPassLimit, 3.0 * catalog::distributionTolerance(entry, a, 8));
}

} // namespace

DistributionResult judgeDistribution(const catalog::WarpEntry &entry, double a,
                                     std::span<const Output> outputs) {
    if (outputs.empty()) {
        throw std::invalid_argument("judgeDistribution: no outputs");
    }
    const UnitSquarePoints points = toUnitSquare(entry, a, outputs);
    const auto total = static_cast<double>(outputs.size());
    DistributionResult result;
    result.total = outputs.size();
    result.invalid = points.invalid();
    result.poleAtoms = points.poleAtoms;
    for (std::size_t i = 0; i < kShapes.size(); ++i) {
        const std::vector<double> counts = countCells(points, kShapes[i].uBins, kShapes[i].vBins);
        result.tests[i] = testHistogram(entry, a, kShapes[i], counts, total);
        result.z = i == 0 ? standardised(result.tests[i], total)
                          : std::max(result.z, standardised(result.tests[i], total));
        if (i == 0) {
            result.counts = counts;
        } else if (i == 1) {
            locateWorstCell(counts, total / static_cast<double>(counts.size()), result);
        }
    }
    const double expected = total / static_cast<double>(result.counts.size());
    for (const double count : result.counts) {
        result.deviation.push_back((count - expected) / std::sqrt(expected));
    }
    const auto smallest = std::min_element(
        result.tests.begin(), result.tests.end(),
        [](const HistogramTest &x, const HistogramTest &y) { return x.pValue < y.pValue; });
    result.pValue = std::min(1.0, 4.0 * smallest->pValue);
    result.rmsError = std::max(result.tests[0].rmsError, result.tests[1].rmsError);
    result.rmsBound = result.tests[1].rmsBound;
    result.passLimit = passLimit(entry, a);
    result.mde = result.tests[1].mde;
    return result;
}

statistics::StageResult asStage(const DistributionResult &result) {
    return {.pValue = result.pValue,
            .effect = result.rmsError,
            .effectBound = result.rmsBound,
            .mde = result.mde,
            .z = result.z,
            .deviation = result.deviation};
}

statistics::LockConfig distributionLock(const catalog::WarpEntry &entry, double a) {
    return {.tolerance = catalog::distributionTolerance(entry, a, 32),
            .passLimit = passLimit(entry, a)};
}

} // namespace battery
