// SPDX-License-Identifier: MIT
#include <statistics/chi_square.h>
#include <statistics/random.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

using namespace statistics; // NOLINT(google-build-using-namespace): the namespace under test

namespace {

/// Histogram of `count` draws whose density is 1 + tilt on the first half of [0, 1), 1 - tilt on
/// the other.
std::vector<double> tiltedHistogram(int bins, int count, double tilt, std::uint64_t seed) {
    Random random(seed);
    std::vector<double> counts(static_cast<std::size_t>(bins));
    for (int i = 0; i < count; ++i) {
        const double side = random.nextDouble() < 0.5 * (1.0 + tilt) ? 0.0 : 0.5;
        const double u = side + 0.5 * random.nextDouble();
        counts[static_cast<std::size_t>(u * bins)] += 1.0;
    }
    return counts;
}

} // namespace

TEST(ChiSquare, MatchesTheTextbookDieExample) {
    // 60 throws of a die; R: chisq.test(c(5,8,9,8,10,20)).
    const std::vector<double> observed{5, 8, 9, 8, 10, 20};
    const ChiSquareResult result = chiSquareTest(observed, std::vector<double>(6, 10.0));
    EXPECT_DOUBLE_EQ(result.statistic, 13.4);
    EXPECT_EQ(result.degreesOfFreedom, 5);
    EXPECT_NEAR(result.pValue, 0.01990522, 1e-8);
    EXPECT_NEAR(chiSquareEqualCells(observed, 60.0).pValue, 0.01990522, 1e-8);
}

TEST(ChiSquare, PoolsNeighboursAndLeavesTheRestInTheLastGroup) {
    // Groups {2, 3}, {6}, {5, 1}: observed 7, 4, 6 for expected 5, 6, 6.
    const std::vector<double> observed{3, 4, 4, 5, 1};
    const std::vector<double> expected{2, 3, 6, 5, 1};
    const ChiSquareResult result = chiSquareTest(observed, expected);
    EXPECT_EQ(result.degreesOfFreedom, 2);
    EXPECT_DOUBLE_EQ(result.statistic, 4.0 / 5.0 + 4.0 / 6.0);
}

TEST(ChiSquare, RejectsSamplesWhereTheDensityIsZero) {
    const std::vector<double> observed{50, 50, 1};
    const std::vector<double> expected{50, 50, 0};
    const ChiSquareResult result = chiSquareTest(observed, expected);
    EXPECT_EQ(result.pValue, 0.0);
    EXPECT_EQ(result.impossibleHits, 1.0);
}

TEST(ChiSquare, DecidesNothingWithoutADegreeOfFreedom) {
    const std::vector<double> one{3.0};
    EXPECT_EQ(chiSquareTest(one, one).degreesOfFreedom, 0);
    EXPECT_EQ(chiSquareTest(one, one).pValue, 1.0);
}

TEST(ChiSquare, RefusesCountsThatAreNone) {
    const std::vector<double> good{1.0, 2.0};
    const std::vector<double> bad{1.0, std::numeric_limits<double>::quiet_NaN()};
    EXPECT_THROW(chiSquareTest(good, bad), std::invalid_argument);
    EXPECT_THROW(chiSquareTest(std::vector<double>{-1.0, 2.0}, good), std::invalid_argument);
    EXPECT_THROW(chiSquareTest(good, std::vector<double>{1.0}), std::invalid_argument);
    EXPECT_THROW(chiSquareTest({}, {}), std::invalid_argument);
    EXPECT_THROW(chiSquareEqualCells(good, 0.0), std::invalid_argument);
}

TEST(ChiSquare, KeepsTailsThatOneMinusTheDistributionLoses) {
    // R: pchisq(300, 63, lower.tail = FALSE) is 3.4e-33 in order of magnitude; 1 - cdf gives 0.
    const double p = toleranceZonePValue(300.0, 63, 1e6, 0.0);
    EXPECT_GT(p, 1e-36);
    EXPECT_LT(p, 1e-28);
}

TEST(ChiSquare, NeedsThePublishedNoncentralityForItsPower) {
    // lambda for power 0.999 at 1e-4: 118 (df 63), 351.6 (df 1023); scipy.stats.ncx2.
    const double n = 1e6;
    EXPECT_NEAR(n * std::pow(rmsErrorDetectable(1023, n), 2), 351.6, 0.1);
    EXPECT_NEAR(n * std::pow(rmsErrorDetectable(63, n), 2), 118.0, 0.5);
}

TEST(ChiSquare, MovesTheCriticalValueByTheTolerance) {
    // 4e6 samples, df 1023, 0.3 %: critical value 1242 instead of 1200 at 1e-4 (both rounded: 0.5
    // moves log10 p by 0.02).
    const double n = 4e6;
    EXPECT_NEAR(std::log10(toleranceZonePValue(1242.0, 1023, n, 0.003)), -4.0, 0.05);
    EXPECT_NEAR(std::log10(toleranceZonePValue(1200.0, 1023, n, 0.0)), -4.0, 0.05);
    EXPECT_NEAR(rmsErrorDetectable(1023, n, {.tolerance = 0.003}), 0.010, 0.0005);
}

TEST(ChiSquare, BoundsTheErrorOfATypicalPass) {
    // At 2^22 samples a statistic at its mean bounds the rms error by 0.39 % (8x8), 0.68 % (32x32).
    const double n = 4194304.0;
    EXPECT_NEAR(rmsErrorUpperBound(63.0, 63, n), 0.0039, 0.0003);
    EXPECT_NEAR(rmsErrorUpperBound(1023.0, 1023, n), 0.0068, 0.0003);
    EXPECT_EQ(rmsErrorUpperBound(1.0, 63, n), 0.0);
    // A gross error: the bound lies just above the error itself.
    const double gross = n * 0.25;
    EXPECT_NEAR(rmsErrorUpperBound(gross, 63, n), 0.5, 0.005);
    EXPECT_GT(rmsErrorUpperBound(gross, 63, n), 0.5);
    EXPECT_EQ(toleranceZonePValue(gross, 63, n, 0.003), 0.0);
}

TEST(ChiSquare, KeepsItsLevelAndFindsATilt) {
    // 400 null runs at level 0.01: 4 expected, more than 14 with probability 2e-5.
    int rejections = 0;
    for (std::uint64_t run = 0; run < 400; ++run) {
        const std::vector<double> counts =
            tiltedHistogram(64, 4096, 0.0, deriveSeed(1, "null", 0, static_cast<unsigned>(run)));
        rejections += chiSquareEqualCells(counts, 4096).pValue < 0.01 ? 1 : 0;
    }
    EXPECT_LE(rejections, 14);
    // The twin: rms error 20 %, above the detectable 17 % (power 0.999 at 1e-4).
    EXPECT_LT(rmsErrorDetectable(63, 4096), 0.2);
    EXPECT_LT(chiSquareEqualCells(tiltedHistogram(64, 4096, 0.2, 2), 4096).pValue, 1e-4);
}
