// SPDX-License-Identifier: MIT
#include "warp_plots.h"

#include <statistics/binomial.h>
#include <statistics/chi_square.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "heat_map.h"

namespace grader {

namespace {

using plot::Form;
using plot::InlinePlot;
using plot::Layer;

constexpr int kSteps = 120;
constexpr double kTests = 4.0; ///< histograms of one distribution test share its level

Layer sampled(const char *label, Form form, double low, double high, const auto &function) {
    Layer layer{label, form, {}};
    for (int i = 0; i <= kSteps; ++i) {
        const double x = low + (high - low) * i / kSteps;
        layer.points.push_back({x, function(x)});
    }
    return layer;
}

} // namespace

InlinePlot residualPlot(const battery::Maps &maps) {
    constexpr double kRange = 6.0;
    constexpr int kBins = 24;
    constexpr double kWidth = 2.0 * kRange / kBins;
    std::vector<double> counts(kBins, 0.0);
    double total = 0.0;
    for (std::size_t i = 0; i < maps.residual.size(); ++i) {
        if (maps.sparse[i]) {
            continue;
        }
        // what is beyond the range stands in the last bin
        const double place = (maps.residual[i] + kRange) / kWidth;
        counts[static_cast<std::size_t>(std::clamp(place, 0.0, kBins - 1.0))] += 1.0;
        total += 1.0;
    }
    Layer bars{"residuals", Form::Bars, {}};
    for (int i = 0; i < kBins; ++i) {
        bars.points.push_back({-kRange + (i + 0.5) * kWidth, counts[static_cast<std::size_t>(i)] /
                                                                 std::max(total, 1.0) / kWidth});
    }
    const auto normal = [](double z) {
        return std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi);
    };
    return {"Histogram of the residuals over the normal density",
            "residual of a cell (beyond ±6 in the last bar)",
            "density",
            {bars, sampled("chance alone", Form::Line, -kRange, kRange, normal)}};
}

InlinePlot statisticPlot(const battery::DistributionResult &distribution, double level) {
    const battery::HistogramTest &test = distribution.tests[0];
    const auto points = static_cast<double>(distribution.total);
    const int df = test.degreesOfFreedom;
    const double critical =
        statistics::toleranceZoneCritical(level / kTests, df, points, test.tolerance);
    const double shift = points * test.tolerance * test.tolerance;
    const double deviation = std::sqrt(2.0 * (df + 2.0 * shift));
    const double low = std::max(0.0, df + shift - 5.0 * deviation);
    const bool isNear = test.statistic < 3.0 * critical;
    const double high =
        std::max(critical + 2.0 * deviation, isNear ? test.statistic + 0.5 * deviation : 0.0);
    const auto density = [&](double x) {
        return statistics::toleranceZoneDensity(x, df, points, test.tolerance);
    };
    InlinePlot plot{"Density of the chi-squared statistic with the measured one",
                    "χ² of 32×32 cells",
                    "density",
                    {sampled("rejected", Form::Area, critical, high, density),
                     sampled("a right warp", Form::Line, low, high, density)}};
    const double peak = density(df + shift);
    // the tail is too thin to be seen: its edge is marked
    plot.layers.push_back({fmt::format("rejected from {:.0f}", critical),
                           Form::Dashes,
                           {{critical, 0.0}, {critical, 0.5 * peak}}});
    plot.layers.push_back({isNear
                               ? fmt::format("measured: {:.0f}", test.statistic)
                               : fmt::format("measured: {:.0f}, far to the right", test.statistic),
                           Form::Spike,
                           {{isNear ? test.statistic : high, peak}}});
    return plot;
}

InlinePlot pValuePlot(std::span<const double> pValues) {
    std::vector<double> sorted(pValues.begin(), pValues.end());
    std::sort(sorted.begin(), sorted.end());
    const auto n = static_cast<double>(sorted.size());
    Layer marks{"p-values of the seeds", Form::Marks, {}};
    Layer band{"95 % of right warps", Form::Band, {}};
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const double rank = static_cast<double>(i) + 1.0;
        const double expected = rank / (n + 1.0);
        marks.points.push_back({expected, sorted[i]});
        // The k-th of n uniform numbers has the Beta law whose quantiles are Clopper's and
        // Pearson's limits.
        band.points.push_back({expected, expected,
                               statistics::clopperPearson(i + 1, sorted.size()).lower,
                               statistics::clopperPearson(i, sorted.size()).upper});
    }
    return {"Sorted p-values of all seeds against an even spread",
            "expected of an even spread",
            "p-value",
            {band, {"even", Form::Dashes, {{0.0, 0.0}, {1.0, 1.0}}}, marks}};
}

InlinePlot slicePlot(const battery::Maps &maps, std::size_t axis) {
    const std::size_t cell = battery::worstCell(maps);
    const auto side = static_cast<std::size_t>(maps.side);
    const std::size_t column = cell % side;
    const std::size_t row = cell / side;
    const double low = maps.domain.low.at(axis);
    const double width = (maps.domain.high.at(axis) - low) / maps.side;
    Layer observed{"observed ±1 σ", Form::Errors, {}};
    Layer expected{"expected", Form::Line, {}};
    for (std::size_t i = 0; i < side; ++i) {
        const std::size_t at = axis == 0 ? row * side + i : i * side + column;
        const double x = low + (static_cast<double>(i) + 0.5) * width;
        const double count = maps.observed[at];
        observed.points.push_back(
            {x, count, std::max(0.0, count - std::sqrt(count)), count + std::sqrt(count)});
        expected.points.push_back({x, maps.expected[at]});
    }
    return {fmt::format("Counts along {} through the worst cell",
                        axis == 0 ? maps.domain.xLabel : maps.domain.yLabel),
            axis == 0 ? maps.domain.xLabel : maps.domain.yLabel,
            "points in a cell",
            {expected, observed}};
}

} // namespace grader
