// SPDX-License-Identifier: MIT
#include <statistics/mean_tests.h>
#include <statistics/random.h>

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <stdexcept>

namespace {

statistics::MomentSummary summaryOf(std::initializer_list<double> values) {
    statistics::RunningMoments moments;
    for (const double value : values) {
        moments.add(value);
    }
    return moments.summary();
}

/// Exponential sample with mean 1.
statistics::MomentSummary exponentialSample(int count, std::uint64_t seed) {
    statistics::Random random(seed);
    statistics::RunningMoments moments;
    for (int i = 0; i < count; ++i) {
        moments.add(-std::log1p(-random.nextDouble()));
    }
    return moments.summary();
}

} // namespace

TEST(OneSampleTest, MatchesStudentsSleepData) {
    // R: t.test(extra ~ group, data = sleep, paired = TRUE): t = 4.0621, df = 9, p = 0.002833.
    const auto test = statistics::oneSampleTest(
        summaryOf({1.2, 2.4, 1.3, 1.3, 0.0, 1.0, 1.8, 0.8, 4.6, 1.4}), 0.0);
    EXPECT_NEAR(test.z, 4.0621, 5e-5);
    EXPECT_EQ(test.degreesOfFreedom, 9.0);
    EXPECT_NEAR(test.pValuePlain, 0.002833, 5e-7);
}

TEST(WelchTest, MatchesStudentsSleepData) {
    // R: t.test(extra ~ group, data = sleep): t = -1.8608, df = 17.776, p = 0.07939.
    const auto test =
        statistics::welchTest(summaryOf({0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0}),
                              summaryOf({1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4}));
    EXPECT_NEAR(test.z, -1.8608, 5e-5);
    EXPECT_NEAR(test.degreesOfFreedom, 17.776, 5e-4);
    EXPECT_NEAR(test.pValuePlain, 0.07939, 5e-6);
}

TEST(HallTransform, LeavesASymmetricSampleAlone) {
    EXPECT_DOUBLE_EQ(statistics::hallTransform(-3.0, 0.0), -3.0);
    // g = 0.3 at z = -3: -3 + 0.9 - 0.09 + 0.05.
    EXPECT_NEAR(statistics::hallTransform(-3.0, 0.3), -2.14, 1e-12);
}

TEST(HallTransform, TakesOutWhatSkewnessDoesToTheLevel) {
    // 4,000 samples of 256 exponentials at level 0.01, left tail the dangerous one. Plain t rejects
    // 2.2 times too often at 1e-3; with Hall 40 are expected at 0.01, above 66 with p < 1e-4.
    int hall = 0;
    for (unsigned run = 0; run < 4000; ++run) {
        const auto test = statistics::oneSampleTest(
            exponentialSample(256, statistics::deriveSeed(5, "hall", 0, run)), 1.0);
        hall += test.pValue < 0.01 ? 1 : 0;
    }
    EXPECT_LE(hall, 66);
}

TEST(OneSampleTest, FindsAnErrorOfTheDetectableSize) {
    const statistics::MomentSummary sample = exponentialSample(4096, 7);
    const auto right = statistics::oneSampleTest(sample, 1.0);
    EXPECT_TRUE(right.gateMet);
    EXPECT_GT(right.pValue, 1e-4);
    const double detectable = statistics::detectableDifference(right.standardError);
    EXPECT_LT(statistics::oneSampleTest(sample, 1.0 + detectable).pValue, 1e-4);
}

TEST(OneSampleTest, ComparesExactlyWhereNothingVaries) {
    const auto constant = summaryOf({2.0, 2.0, 2.0});
    EXPECT_EQ(statistics::oneSampleTest(constant, 2.0).pValue, 1.0);
    EXPECT_EQ(statistics::oneSampleTest(constant, 2.5).pValue, 0.0);
    EXPECT_EQ(statistics::absoluteDifferenceBound(statistics::oneSampleTest(constant, 2.5)), 0.5);
}

TEST(OneSampleTest, ClosesTheGateOnStrongSkewness) {
    EXPECT_FALSE(statistics::oneSampleTest(exponentialSample(64, 1), 1.0).gateMet);
    EXPECT_THROW(statistics::oneSampleTest(summaryOf({1.0}), 1.0), std::invalid_argument);
    EXPECT_THROW(statistics::welchTest(summaryOf({1.0, 2.0}), summaryOf({})),
                 std::invalid_argument);
}

TEST(DetectableDifference, IsThePublishedMultipleOfTheError) {
    // (z(5e-5) + z(1e-3))^2 = 48.7.
    EXPECT_NEAR(std::pow(statistics::detectableDifference(1.0), 2), 48.7, 0.1);
}

TEST(AbsoluteDifferenceBound, IsTheConfidenceLimit) {
    // R: qt(0.975, 9) = 2.262157.
    const auto test = statistics::meanTest(1.0, 4.0, 0.0, 9.0);
    EXPECT_NEAR(statistics::absoluteDifferenceBound(test, 0.05), 1.0 + 2.0 * 2.262157, 1e-5);
}
