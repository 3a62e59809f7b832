// SPDX-License-Identifier: MIT
#include <statistics/random.h>
#include <statistics/replicates.h>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace statistics {
namespace {

constexpr std::size_t kPlaces = 1024;
constexpr int kSamples = 64;
/// Two-sided level 1e-6.
constexpr double kLimit = 4.9;

/// Skewed samples (of an exponential law) whose mean differs from place to place.
/// \param again  part of the samples that repeat the first one
std::vector<MomentSummary> image(std::uint64_t seed, double again = 0.0, double scale = 1.0) {
    Random random(seed);
    std::vector<MomentSummary> result;
    for (std::size_t i = 0; i < kPlaces; ++i) {
        const double mean = scale * (0.5 + static_cast<double>(i % 7));
        const double first = -std::log1p(-random.nextDouble());
        RunningMoments moments;
        for (int k = 0; k < kSamples; ++k) {
            const double fresh = -std::log1p(-random.nextDouble());
            moments.add(mean * (random.nextDouble() < again ? first : fresh));
        }
        result.push_back(moments.summary());
    }
    return result;
}

std::vector<std::vector<MomentSummary>> replicates(double again) {
    std::vector<std::vector<MomentSummary>> result;
    for (unsigned i = 0; i < 8; ++i) {
        result.push_back(image(deriveSeed(1, "replicates", 0, i), again));
    }
    return result;
}

TEST(Replicates, IndependentSamplesVaryBetweenAsWithin) {
    const RatioEstimate found = betweenWithinRatio(replicates(0));
    EXPECT_LT(std::fabs(found.ratio - 1), kLimit * found.standardError);
    EXPECT_LT(found.standardError, 0.03); // sqrt(2 / (7 1024)) = 1.7 %, and unequal places
}

// A tenth of the samples is one number again: n times its square of the variance goes between, so
// that the ratio becomes 1 + (64 - 1) / 100.
TEST(Replicates, NumbersUsedAgainAreFound) {
    const RatioEstimate found = betweenWithinRatio(replicates(0.1));
    EXPECT_TRUE(found.differsFromOne(0.1, kLimit)) << found.ratio;
    EXPECT_NEAR(found.ratio, 1.64, 0.2);
}

TEST(Replicates, TheErrorIsWhatTheVarianceSays) {
    const RatioEstimate right = errorVarianceRatio(image(1), image(2));
    EXPECT_LT(std::fabs(right.ratio - 1), kLimit * right.standardError);
    const RatioEstimate copied = errorVarianceRatio(image(1), image(1));
    EXPECT_TRUE(copied.differsFromOne(0.5, kLimit)) << copied.ratio;
    const RatioEstimate biased = errorVarianceRatio(image(1, 0, 1.2), image(2));
    EXPECT_TRUE(biased.differsFromOne(0.5, kLimit)) << biased.ratio;
}

TEST(Replicates, VarianceGoesWithTheSquareOfTheScale) {
    const RatioEstimate found = varianceRatio(image(1, 0, 1.5), image(2));
    EXPECT_NEAR(found.ratio, 2.25, kLimit * found.standardError);
    EXPECT_TRUE(found.differsFromOne(0.5, kLimit));
}

// The same number three times tells nothing more than once.
TEST(Replicates, ChannelsOfAPlaceAreNoEvidenceOfTheirOwn) {
    const std::vector<MomentSummary> a = image(1);
    const std::vector<MomentSummary> b = image(2);
    std::vector<MomentSummary> grey[2];
    for (std::size_t i = 0; i < kPlaces; ++i) {
        grey[0].insert(grey[0].end(), 3, a[i]);
        grey[1].insert(grey[1].end(), 3, b[i]);
    }
    const RatioEstimate one = errorVarianceRatio(a, b);
    const RatioEstimate three = errorVarianceRatio(grey[0], grey[1], 3);
    EXPECT_NEAR(three.ratio, one.ratio, 1e-12);
    EXPECT_NEAR(three.standardError, one.standardError, 1e-12);
}

TEST(Replicates, NothingOverNothingIsRight) {
    const std::vector<MomentSummary> black(4, MomentSummary{2, 0, 0, 0});
    EXPECT_EQ(errorVarianceRatio(black, black).ratio, 1.0);
    const std::vector<MomentSummary> grey(4, MomentSummary{2, 1, 0, 0});
    EXPECT_TRUE(errorVarianceRatio(grey, black).differsFromOne(0.5, kLimit));
}

TEST(Replicates, ShapesHaveToAgree) {
    EXPECT_THROW(betweenWithinRatio({image(1)}), std::invalid_argument);
    EXPECT_THROW(betweenWithinRatio({image(1), {}}), std::invalid_argument);
    EXPECT_THROW(ratioOfSums(std::vector<double>{1}, std::vector<double>{1}),
                 std::invalid_argument);
    EXPECT_THROW(varianceRatio(image(1), {}), std::invalid_argument);
}

} // namespace
} // namespace statistics
