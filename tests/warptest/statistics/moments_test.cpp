// SPDX-License-Identifier: MIT
#include <statistics/moments.h>
#include <statistics/random.h>

#include <gtest/gtest.h>

#include <cmath>

using statistics::MomentSummary;
using statistics::RunningMoments;

TEST(RunningMoments, MatchesASampleDoneByHand) {
    // {1, 2, 3, 4, 10}: deviations -3 -2 -1 0 6; squares sum to 50, cubes to 180.
    RunningMoments moments;
    for (const double x : {1.0, 2.0, 3.0, 4.0, 10.0}) {
        moments.add(x);
    }
    const MomentSummary summary = moments.summary();
    EXPECT_DOUBLE_EQ(summary.count, 5.0);
    EXPECT_DOUBLE_EQ(summary.mean, 4.0);
    EXPECT_DOUBLE_EQ(summary.variance, 12.5);
    EXPECT_DOUBLE_EQ(summary.thirdCentral, 180.0 * 5.0 / 12.0);
    EXPECT_DOUBLE_EQ(statistics::skewness(summary), 75.0 / std::pow(12.5, 1.5));
}

TEST(RunningMoments, DoesNotDependOnHowTheSampleIsSplit) {
    statistics::Random random(3);
    RunningMoments whole;
    RunningMoments left;
    RunningMoments right;
    for (int i = 0; i < 1000; ++i) {
        const double x = 1e6 + std::exp(random.nextDouble()); // a mean far above the deviation
        whole.add(x);
        (i < 137 ? left : right).add(x);
    }
    left.merge(right);
    // 1,000 additions at 1e6, each rounded by at most half an ulp (6e-11).
    EXPECT_NEAR(left.summary().mean, whole.summary().mean, 6e-8);
    EXPECT_NEAR(left.summary().variance / whole.summary().variance, 1.0, 1e-8);
    EXPECT_NEAR(left.summary().thirdCentral / whole.summary().thirdCentral, 1.0, 1e-6);
}

TEST(RunningMoments, IsZeroWhereTooFewValuesAreKnown) {
    RunningMoments moments;
    EXPECT_EQ(moments.summary().count, 0.0);
    moments.merge(RunningMoments{});
    moments.add(2.0);
    EXPECT_EQ(moments.summary().variance, 0.0);
    moments.add(4.0);
    EXPECT_EQ(moments.summary().variance, 2.0);
    EXPECT_EQ(moments.summary().thirdCentral, 0.0);
    EXPECT_EQ(statistics::skewness({}), 0.0);
}
