// SPDX-License-Identifier: MIT
#include "distribution.h"

#include <statistics/chi_square.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>

namespace battery {

namespace {

HistogramTest testHistogram(const catalog::WarpEntry &entry, double a, const Histogram &histogram,
                            double total) {
    const statistics::ChiSquareResult plain =
        statistics::chiSquareEqualCells(histogram.counts, total);
    HistogramTest test{.uBins = histogram.uBins,
                       .vBins = histogram.vBins,
                       .statistic = plain.statistic,
                       .degreesOfFreedom = plain.degreesOfFreedom};
    test.tolerance = catalog::distributionTolerance(entry, a, histogram.uBins);
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

std::array<Histogram, 4> countHistograms(const UnitSquarePoints &points) {
    std::array<Histogram, 4> histograms{Histogram{32, 32}, Histogram{8, 8}, Histogram{256, 1},
                                        Histogram{1, 256}};
    std::array<std::uint32_t, 1024> fine{}; // 32x32
    std::array<std::uint32_t, 256> alongU{};
    std::array<std::uint32_t, 256> alongV{};
    for (std::size_t i = 0; i < points.u.size(); ++i) {
        const auto row = std::min(255U, static_cast<unsigned>(points.u[i] * 256.0));
        const auto column = std::min(255U, static_cast<unsigned>(points.v[i] * 256.0));
        ++fine[row / 8 * 32 + column / 8];
        ++alongU[row];
        ++alongV[column];
    }
    histograms[0].counts.assign(fine.begin(), fine.end());
    histograms[1].counts.assign(64, 0.0);
    for (std::size_t cell = 0; cell < fine.size(); ++cell) {
        histograms[1].counts[cell / 128 * 8 + cell % 32 / 4] += fine[cell];
    }
    histograms[2].counts.assign(alongU.begin(), alongU.end());
    histograms[3].counts.assign(alongV.begin(), alongV.end());
    return histograms;
}

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
    std::array<Histogram, 4> histograms = countHistograms(points);
    for (std::size_t i = 0; i < histograms.size(); ++i) {
        result.tests[i] = testHistogram(entry, a, histograms[i], total);
        result.z = i == 0 ? standardised(result.tests[i], total)
                          : std::max(result.z, standardised(result.tests[i], total));
    }
    const std::vector<double> &coarse = histograms[1].counts;
    locateWorstCell(coarse, total / static_cast<double>(coarse.size()), result);
    result.counts = std::move(histograms[0].counts);
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
