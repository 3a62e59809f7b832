// SPDX-License-Identifier: MIT
#include <statistics/binomial.h>
#include <statistics/random.h>

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <vector>

TEST(ClopperPearson, MatchesPublishedIntervals) {
    // R: binom.test(10, 100)$conf.int is 0.04900469 0.17622260.
    const statistics::Interval interval = statistics::clopperPearson(10, 100);
    EXPECT_NEAR(interval.lower, 0.04900469, 1e-8);
    EXPECT_NEAR(interval.upper, 0.17622260, 1e-8);
}

TEST(ClopperPearson, IsOneSidedAtTheEnds) {
    // 60 of 60: at least 94.0 %; 0 of 60 is the mirror image.
    EXPECT_NEAR(statistics::clopperPearson(60, 60).lower, 0.9404, 5e-5);
    EXPECT_EQ(statistics::clopperPearson(60, 60).upper, 1.0);
    EXPECT_EQ(statistics::clopperPearson(0, 60).lower, 0.0);
    EXPECT_NEAR(statistics::clopperPearson(0, 60).upper, 1.0 - 0.9404, 5e-5);
    EXPECT_THROW(statistics::clopperPearson(0, 0), std::invalid_argument);
    EXPECT_THROW(statistics::clopperPearson(3, 2), std::invalid_argument);
}

TEST(MultinomialTest, MatchesMendelsPeas) {
    // R: chisq.test(c(315,108,101,32), p = c(9,3,3,1)/16): 0.47002, df 3, p = 0.9254.
    const std::array<double, 4> counts{315, 108, 101, 32};
    const std::array<double, 4> odds{9.0 / 16, 3.0 / 16, 3.0 / 16, 1.0 / 16};
    const auto result = statistics::multinomialTest(counts, odds);
    EXPECT_NEAR(result.statistic, 0.470024, 1e-6);
    EXPECT_EQ(result.degreesOfFreedom, 3);
    EXPECT_NEAR(result.pValue, 0.925426, 1e-6);
}

TEST(MultinomialTest, KeepsItsLevelAndFindsWrongOdds) {
    const std::array<double, 3> odds{0.6, 0.3, 0.1};
    const std::array<double, 3> wrong{0.5, 0.4, 0.1};
    int rejections = 0; // of 500 at 0.01: 5 expected, more than 17 with probability 1e-5
    std::vector<double> counts;
    for (unsigned run = 0; run < 500; ++run) {
        statistics::Random random(statistics::deriveSeed(11, "picks", 0, run));
        counts.assign(3, 0.0);
        for (int i = 0; i < 1000; ++i) {
            const double u = random.nextDouble();
            counts[u < 0.6 ? 0 : (u < 0.9 ? 1 : 2)] += 1.0;
        }
        rejections += statistics::multinomialTest(counts, odds).pValue < 0.01 ? 1 : 0;
    }
    EXPECT_LE(rejections, 17);
    EXPECT_LT(statistics::multinomialTest(counts, wrong).pValue, 1e-4);
}

TEST(MultinomialTest, RejectsAPickOfProbabilityZero) {
    const std::array<double, 3> counts{50, 50, 1};
    const std::array<double, 3> odds{0.5, 0.5, 0.0};
    EXPECT_EQ(statistics::multinomialTest(counts, odds).pValue, 0.0);
    const std::array<double, 3> notNormalised{0.5, 0.5, 0.5};
    EXPECT_THROW(statistics::multinomialTest(counts, notNormalised), std::invalid_argument);
}
