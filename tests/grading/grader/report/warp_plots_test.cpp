// SPDX-License-Identifier: MIT
#include <catalog/warp_catalog.h>
#include <grader/report/warp_plots.h>
#include <statistics/chi_square.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace grader {
namespace {

/// Of the square, in 4x4 cells with 10 points expected in each.
battery::Maps mapsOf(std::vector<double> counts, std::size_t points = 160) {
    return battery::mapsOfCounts(catalog::requireWarp("square"), 0.0, std::move(counts), points);
}

const plot::Layer &layer(const plot::InlinePlot &plot, plot::Form form) {
    return *std::find_if(plot.layers.begin(), plot.layers.end(),
                         [form](const plot::Layer &one) { return one.form == form; });
}

TEST(ResidualPlot, IsADensityWhoseLastBarHoldsWhatIsBeyond) {
    std::vector<double> counts(16, 10.0);
    counts[2] = 1000.0;
    const plot::InlinePlot plot = residualPlot(mapsOf(counts));
    const std::vector<plot::Point> &bars = layer(plot, plot::Form::Bars).points;
    double area = 0.0;
    for (const plot::Point &bar : bars)
        area += bar.y * (bars[1].x - bars[0].x);
    EXPECT_NEAR(area, 1.0, 1e-12);
    EXPECT_NEAR(bars.back().y * 0.5, 1.0 / 16.0, 1e-12);
    // the line over it has the peak of N(0, 1)
    const std::vector<plot::Point> &line = layer(plot, plot::Form::Line).points;
    EXPECT_NEAR(line[line.size() / 2].y, 0.39894, 1e-5);
}

battery::DistributionResult distributionWith(double statistic) {
    battery::DistributionResult result;
    result.total = 65536;
    result.tests[0] = {.uBins = 32, .vBins = 32, .statistic = statistic, .degreesOfFreedom = 1023};
    return result;
}

TEST(StatisticPlot, MarksTheRejectedTailAndTheMeasuredValue) {
    const double critical = statistics::toleranceZoneCritical(1e-4 / 4.0, 1023, 65536.0, 0.0);
    const plot::InlinePlot plot = statisticPlot(distributionWith(1040.0), 1e-4);
    EXPECT_EQ(layer(plot, plot::Form::Area).points.front().x, critical);
    EXPECT_EQ(layer(plot, plot::Form::Spike).points[0].x, 1040.0);
    EXPECT_EQ(layer(plot, plot::Form::Spike).label, "measured: 1040");
    // the mode of chi^2 is df - 2
    const std::vector<plot::Point> &line = layer(plot, plot::Form::Line).points;
    const auto peak = std::max_element(line.begin(), line.end(),
                                       [](const auto &a, const auto &b) { return a.y < b.y; });
    EXPECT_NEAR(peak->x, 1021.0, line[1].x - line[0].x);
}

TEST(StatisticPlot, KeepsTheDensityInSightOfAFarValue) {
    const plot::InlinePlot plot = statisticPlot(distributionWith(1e6), 1e-4);
    EXPECT_EQ(layer(plot, plot::Form::Spike).label, "measured: 1000000, far to the right");
    EXPECT_LT(layer(plot, plot::Form::Spike).points[0].x, 2000.0);
}

TEST(PValuePlot, HasABandAroundAnEvenSpread) {
    const std::vector<double> pValues{0.9, 0.1, 0.5};
    const plot::InlinePlot plot = pValuePlot(pValues);
    const std::vector<plot::Point> &marks = layer(plot, plot::Form::Marks).points;
    ASSERT_EQ(marks.size(), 3U);
    EXPECT_EQ(marks[0].x, 0.25);
    EXPECT_EQ(marks[0].y, 0.1);
    EXPECT_EQ(marks[2].y, 0.9);
    // the least of three uniform numbers: 1 - (1 - q)^(1/3) at 2.5 % and 97.5 %
    const plot::Point &first = layer(plot, plot::Form::Band).points[0];
    EXPECT_NEAR(first.low, 0.0084, 1e-4);
    EXPECT_NEAR(first.high, 0.7076, 1e-4);
}

TEST(SlicePlot, CutsThroughTheWorstCell) {
    std::vector<double> counts(16, 10.0);
    counts[6] = 50.0; // column 2, row 1
    counts[4] = 11.0; // column 0, row 1
    counts[14] = 12.0;
    const plot::InlinePlot alongX = slicePlot(mapsOf(counts), 0);
    const plot::InlinePlot alongY = slicePlot(mapsOf(counts), 1);
    const std::vector<plot::Point> &x = layer(alongX, plot::Form::Errors).points;
    const std::vector<plot::Point> &y = layer(alongY, plot::Form::Errors).points;
    EXPECT_EQ(alongX.xLabel, "x");
    EXPECT_EQ(alongY.xLabel, "y");
    ASSERT_EQ(x.size(), 4U);
    EXPECT_EQ(x[0].y, 11.0);
    EXPECT_EQ(x[2].y, 50.0);
    EXPECT_EQ(x[2].x, 0.625);
    EXPECT_EQ(y[1].y, 50.0);
    EXPECT_EQ(y[3].y, 12.0);
    EXPECT_NEAR(layer(alongX, plot::Form::Line).points[2].y, 10.0, 1e-9);
}

} // namespace
} // namespace grader
