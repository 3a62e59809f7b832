// SPDX-License-Identifier: MIT
#include <statistics/convergence.h>
#include <statistics/random.h>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace statistics {
namespace {

constexpr std::size_t kPixels = 2000;

/// Deviation of a mean of `samples` numbers of variance 1, skewed like light.
double noise(Random &random, int samples) {
    double sum = 0;
    for (int i = 0; i < samples; ++i)
        sum += -std::log(1 - random.nextDouble()) - 1;
    return sum / samples;
}

/// \param bias   added to every pixel
/// \param reuse  how many samples are the same numbers again: error falls as if there were fewer
std::vector<MomentSummary> render(std::uint64_t seed, int samples, double bias = 0, int reuse = 1) {
    Random random(seed);
    std::vector<MomentSummary> image;
    for (std::size_t i = 0; i < kPixels; ++i) {
        const double scale = 1 + 0.001 * static_cast<double>(i);
        const double deviation = noise(random, std::max(1, samples / reuse));
        image.push_back({static_cast<double>(samples), scale * (3 + bias + deviation),
                         scale * scale, 2 * scale * scale * scale});
    }
    return image;
}

ConvergenceFit fit(std::uint64_t seed, double bias, bool reuses) {
    const auto a = render(seed + 1, 256);
    const auto b = render(seed + 2, 256);
    std::vector<ErrorsAt> errors;
    std::uint64_t run = seed + 3;
    for (const int samples : {1, 4, 16, 64}) {
        ErrorsAt at{static_cast<double>(samples), {}};
        for (int k = 0; k < 6; ++k)
            at.errors.push_back(
                debiasedError(render(run++, samples, bias, reuses ? samples : 1), a, b));
        errors.push_back(at);
    }
    return fitConvergence(errors);
}

TEST(DebiasedError, IsTheVarianceOfTheImageWhateverTheReferencesNoise) {
    // 2000 pixels, kurtosis of the mean of 4 exponentials 1.5: deviation of the mean square
    // sqrt(3.5 / 2000) = 4 %; the halves' noise adds 2 %. 4.9 deviations are a level of 1e-6.
    const double error = debiasedError(render(1, 4), render(2, 4), render(3, 4));
    EXPECT_NEAR(4 * error, 1, 0.25);
    // The naive one holds the reference's noise: 2 instead of 1.
    const auto reference = render(2, 4);
    EXPECT_GT(4 * debiasedError(render(1, 4), reference, reference), 1.5);
}

TEST(DebiasedError, NeedsNoiseAndOneSize) {
    const std::vector<MomentSummary> flat(3, {4, 1, 0, 0});
    EXPECT_THROW(debiasedError(flat, flat, flat), std::invalid_argument);
    EXPECT_THROW(debiasedError(render(1, 4), flat, flat), std::invalid_argument);
}

TEST(FitConvergence, FindsTheSlopeOfRightCode) {
    const ConvergenceFit right = fit(100, 0, false);
    EXPECT_TRUE(right.isMonteCarlo()) << right.slope << " in " << right.low << ", " << right.high;
    EXPECT_FALSE(right.isOtherwise());
    ASSERT_EQ(right.points.size(), 4U);
    EXPECT_NEAR(right.points[1].rmse, 0.5, 0.05);
    EXPECT_LT(right.points[1].low, right.points[1].rmse);
    EXPECT_GT(right.points[1].high, right.points[1].rmse);
}

TEST(FitConvergence, CoversTheSlopeAsOftenAsItSays) {
    // 95 % intervals of 200 runs: 190 expected, deviation 3.1; 178 is 99.99 %.
    int covered = 0;
    for (std::uint64_t run = 0; run < 200; ++run) {
        Random random(run);
        std::vector<ErrorsAt> errors;
        for (const double samples : {1.0, 4.0, 16.0}) {
            ErrorsAt at{samples, {}};
            for (int k = 0; k < 5; ++k)
                at.errors.push_back((1 + 0.02 * noise(random, 20)) / samples);
            errors.push_back(at);
        }
        covered += fitConvergence(errors, 0.05).isOtherwise() ? 0 : 1;
    }
    EXPECT_GE(covered, 178);
    EXPECT_LT(covered, 200);
}

/// Intervals of 99 % that miss the slope of right code, of `runs`.
/// \param variance  of a sample, if the reference's samples have 1
int missesAgainstNoisyReference(double variance, int runs, bool countsReference) {
    constexpr std::size_t kPlaces = 300;
    constexpr int kTerms = 3;
    constexpr double kReferenceSamples = 64.0; // 4 times the most, as `converge` renders it
    Random random(77);
    const auto image = [&random](double sampleVariance, double samples) {
        std::vector<MomentSummary> pixels;
        for (std::size_t i = 0; i < kPlaces; ++i)
            pixels.push_back({samples,
                              std::sqrt(kTerms * sampleVariance / samples) * noise(random, kTerms),
                              sampleVariance, 0});
        return pixels;
    };
    int missed = 0;
    for (int run = 0; run < runs; ++run) {
        const auto a = image(1, kReferenceSamples);
        const auto b = image(1, kReferenceSamples);
        std::vector<ErrorsAt> errors;
        for (const double samples : {1.0, 4.0, 16.0}) {
            ErrorsAt at{samples, {}};
            for (int k = 0; k < 8; ++k)
                at.errors.push_back(debiasedError(image(variance, samples), a, b));
            errors.push_back(at);
        }
        missed +=
            fitConvergence(errors, 0.01, countsReference ? commonError(a, b) : 0).isOtherwise() ? 1
                                                                                                : 0;
    }
    return missed;
}

TEST(FitConvergence, CountsTheNoiseThatTheReferenceGivesToAllReplicates) {
    // 200 runs at 1 %: 2 expected; more than 9 with probability 5e-5.
    EXPECT_LE(missesAgainstNoisyReference(1.0, 200, true), 9);
    EXPECT_LE(missesAgainstNoisyReference(0.2, 200, true), 9);
    EXPECT_LE(missesAgainstNoisyReference(0.1, 200, true), 9);
    // The wrong twin knows only the replicates' scatter.
    EXPECT_GT(missesAgainstNoisyReference(0.1, 200, false), 9);
}

TEST(FitConvergence, RejectsAStreamThatIsUsedAgainAndABias) {
    EXPECT_TRUE(fit(200, 0, true).isOtherwise());
    EXPECT_TRUE(fit(300, 0.5, false).isOtherwise());
}

TEST(FitConvergence, SaysWhatItNeeds) {
    const auto fitOf = [](std::vector<ErrorsAt> errors) {
        return fitConvergence(errors);
    };
    EXPECT_THROW(fitOf({{1, {1, 1}}}), std::invalid_argument);
    EXPECT_THROW(fitOf({{1, {1}}, {4, {1}}}), std::invalid_argument);
    EXPECT_THROW(fitOf({{4, {1, 1}}, {4, {1, 1}}}), std::invalid_argument);
    EXPECT_THROW(fitOf({{1, {1, 1}}, {4, {-1, 0.5}}}), std::invalid_argument);
}

} // namespace
} // namespace statistics
