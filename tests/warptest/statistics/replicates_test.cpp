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
constexpr double kLevel = 1e-6;
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
    EXPECT_NEAR(found.ratio, 1, kLimit * found.standardError);
    EXPECT_LT(found.standardError, 0.03); // sqrt(2 / (7 1024)) = 1.7 %, and unequal places
}

// A tenth of the samples is one number again: n times its square of the variance goes between, so
// that the ratio becomes 1 + (64 - 1) / 100.
TEST(Replicates, NumbersUsedAgainAreFound) {
    const RatioEstimate found = betweenWithinRatio(replicates(0.1));
    EXPECT_GT(found.ratio - 1, kLimit * found.standardError);
    EXPECT_NEAR(found.ratio, 1.64, 0.2);
}

TEST(Replicates, TheErrorIsWhatTheVarianceSays) {
    const RatioEstimate right = errorVarianceRatio(image(1), image(2));
    EXPECT_NEAR(right.ratio, 1, kLimit * right.standardError);
    const RatioEstimate copied = errorVarianceRatio(image(1), image(1));
    EXPECT_EQ(copied.ratio, 0.0);
    const RatioEstimate biased = errorVarianceRatio(image(1, 0, 1.2), image(2));
    EXPECT_GT(biased.ratio - 1, kLimit * biased.standardError);
}

TEST(Replicates, VarianceGoesWithTheSquareOfTheScale) {
    const RatioEstimate found = varianceRatio(image(1, 0, 1.5), image(2));
    EXPECT_NEAR(found.ratio, 2.25, kLimit * found.standardError);
    EXPECT_GT(found.ratio - 1, kLimit * found.standardError);
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
    const RatioEstimate three = errorVarianceRatio(grey[0], grey[1], {.channels = 3});
    EXPECT_NEAR(three.ratio, one.ratio, 1e-12);
    EXPECT_NEAR(three.standardError, one.standardError, 1e-12);
}

// One place with all of the noise leaves an equally weighted sum of squares with one degree of
// freedom; with weights it is one of many.
TEST(Replicates, TheCommonErrorIsTheBiasAndNothingElse) {
    const std::vector<MomentSummary> references[] = {image(11), image(12)};
    const auto common = [&](const std::vector<MomentSummary> &a,
                            const std::vector<MomentSummary> &b) {
        const ImagePair pair = {a, references[0], b, references[1]};
        return commonError({&pair, 1});
    };
    EXPECT_GT(common(image(1), image(2)).pValue, kLevel);
    // 10 % off: the squared bias is 0.01 times the mean square of 0.5, ..., 6.5: 16.25.
    const CommonError biased = common(image(1, 0, 1.1), image(2, 0, 1.1));
    EXPECT_LT(biased.pValue, kLevel);
    EXPECT_NEAR(biased.meanSquare, 0.1625, kLimit * biased.standardError);
    EXPECT_LT(common(image(1), image(1)).pValue, kLevel) << "the same noise twice";
}

TEST(Replicates, TheErrorIsWhatTheNoiseSays) {
    const std::vector<MomentSummary> right = image(21);
    const std::vector<MomentSummary> reference = image(22);
    EXPECT_GT(errorPValue(image(1), right, reference), kLevel);
    EXPECT_LT(errorPValue(image(1, 0, 1.2), right, reference), kLevel);
    // a fifth of the samples is one number again: the mean is right, its error is not
    EXPECT_LT(errorPValue(image(1, 0.2), right, reference), kLevel);
    std::vector<MomentSummary> smoothed = image(1);
    for (std::size_t i = 0; i < kPlaces; ++i)
        smoothed[i].mean = 0.5 * (smoothed[i].mean + reference[i].mean);
    EXPECT_LT(errorPValue(smoothed, right, reference), kLevel) << "too small";
    // Another estimator with four times the variance: as good as right.
    std::vector<MomentSummary> noisier = image(2);
    for (std::size_t i = 0; i < kPlaces; ++i) {
        const double mean = 0.5 + static_cast<double>(i % 7);
        noisier[i].mean = mean + 2 * (noisier[i].mean - mean);
        noisier[i].variance *= 4;
    }
    EXPECT_GT(errorPValue(noisier, right, reference), kLevel);
}

TEST(Replicates, ErrorsKeepTheirLevel) {
    constexpr std::uint64_t kRuns = 400;
    int below = 0;
    for (std::uint64_t run = 0; run < kRuns; ++run)
        below += errorPValue(image(3 * run), image(3 * run + 1), image(3 * run + 2)) <= 0.05;
    EXPECT_NEAR(below, 20, 21); // 4.9 deviations of 4.4
}

TEST(Replicates, WeightsKeepOneNoisyPlaceFromDecidingAlone) {
    std::vector<MomentSummary> a = image(1);
    std::vector<MomentSummary> b = image(2);
    for (auto *side : {&a, &b}) {
        (*side)[5].variance *= 1e6;
        (*side)[5].mean *= 1e3;
    }
    const std::vector<double> weights = noiseWeights(b);
    const RatioEstimate weighted = errorVarianceRatio(a, b, {.weights = weights});
    EXPECT_LT(weighted.standardError, 0.2);
    const double difference = a[5].mean - b[5].mean;
    const double alone = difference * difference / ((a[5].variance + b[5].variance) / kSamples);
    EXPECT_NEAR(errorVarianceRatio(a, b).ratio, alone, 0.02) << "that place decides";
}

TEST(Replicates, NothingOverNothingIsRight) {
    const std::vector<MomentSummary> black(4, MomentSummary{2, 0, 0, 0});
    EXPECT_EQ(errorVarianceRatio(black, black).ratio, 1.0);
    const std::vector<MomentSummary> grey(4, MomentSummary{2, 1, 0, 0});
    EXPECT_TRUE(std::isinf(errorVarianceRatio(grey, black).ratio));
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
