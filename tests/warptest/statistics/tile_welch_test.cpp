// SPDX-License-Identifier: MIT
#include <statistics/random.h>
#include <statistics/tile_welch.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <vector>

using namespace statistics; // NOLINT(google-build-using-namespace): the namespace under test

namespace {

constexpr int kSize = 32;
constexpr std::size_t kPixels = 1024;

using Gain = std::function<double(int x, int y)>;

/// Exponential samples (skewness 2) whose mean is a gradient times `gain`.
std::vector<MomentSummary> render(int samples, std::uint64_t seed, const Gain &gain) {
    Random random(seed);
    std::vector<MomentSummary> pixels;
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            RunningMoments moments;
            const double mean = (0.5 + x / 16.0) * gain(x, y);
            for (int i = 0; i < samples; ++i) {
                moments.add(-mean * std::log1p(-random.nextDouble()));
            }
            pixels.push_back(moments.summary());
        }
    }
    return pixels;
}

double right(int /*x*/, int /*y*/) {
    return 1.0;
}

MomentImage image(const std::vector<MomentSummary> &pixels) {
    return {kSize, kSize, pixels};
}

TileWelchResult compare(const Gain &gain, std::uint64_t seed = 1) {
    const auto student = render(64, deriveSeed(seed, "student"), gain);
    const auto reference = render(64, deriveSeed(seed, "reference"), right);
    return tileWelchTest(image(student), image(reference));
}

} // namespace

TEST(TileWelch, PassesTheSameLaw) {
    const TileWelchResult result = compare(right);
    EXPECT_EQ(result.tiles.size(), 16U);
    EXPECT_TRUE(result.gateMet);
    EXPECT_GT(result.pValue, 1e-4);
    EXPECT_LT(result.globalBound, 0.05);
}

TEST(TileWelch, KeepsItsLevel) {
    // 60 runs at 0.05: 3 expected, more than 12 with probability 2e-5.
    int rejections = 0;
    for (std::uint64_t run = 0; run < 60; ++run) {
        const auto student = render(16, deriveSeed(run, "student"), right);
        const auto reference = render(16, deriveSeed(run, "reference"), right);
        rejections += tileWelchTest(image(student), image(reference)).pValue < 0.05 ? 1 : 0;
    }
    EXPECT_LE(rejections, 12);
}

TEST(TileWelch, FindsACommonFactorGlobally) {
    const TileWelchResult result = compare([](int, int) { return 1.05; });
    EXPECT_GT(0.05, result.globalMde);
    EXPECT_LT(result.global.pValue, 1e-4);
    EXPECT_NEAR(result.globalRelativeError, 0.05, 0.03);
}

TEST(TileWelch, FindsOneWrongTile) {
    const TileWelchResult result =
        compare([](int x, int y) { return x >= 8 && x < 16 && y >= 16 && y < 24 ? 1.3 : 1.0; });
    EXPECT_LT(result.maxPValue, 1e-4);
    EXPECT_EQ(result.tiles[result.worstTile].x, 8);
    EXPECT_EQ(result.tiles[result.worstTile].y, 16);
}

TEST(TileWelch, FindsErrorsThatCancelInTheMean) {
    // Tiles 10 % too bright and too dark by turns: the mean sees nothing (power 0.999 of the sum).
    const TileWelchResult result =
        compare([](int x, int y) { return (x / 8 + y / 8) % 2 == 0 ? 1.1 : 0.9; });
    EXPECT_LT(result.sumPValue, 1e-4);
    EXPECT_GT(result.global.pValue, 1e-4);
}

TEST(TileWelch, ComparesExactlyWhereNothingVaries) {
    const std::vector<MomentSummary> black(kPixels, {16.0, 0.0, 0.0, 0.0});
    const std::vector<MomentSummary> lit(kPixels, {16.0, 1.0, 0.0, 0.0});
    std::vector<MomentSummary> rounded(kPixels, {16.0, 1.0 + 1e-6, 0.0, 0.0});
    EXPECT_EQ(tileWelchTest(image(black), image(black)).pValue, 1.0);
    EXPECT_EQ(tileWelchTest(image(black), image(lit)).pValue, 0.0);
    EXPECT_EQ(tileWelchTest(image(rounded), image(lit)).pValue, 1.0);
}

TEST(TileWelch, PromisesToFindWhatTilesWithNoiseAllow) {
    const double full = compare(right).tileMde;
    EXPECT_GT(full, 0.1);
    const auto dark = [](int x, int) {
        return x < 8 ? 1.0 : 0.0;
    };
    const auto student = render(64, 1, dark);
    const auto reference = render(64, 2, dark);
    // 12 of 16 tiles are black on both sides; the leftmost are as noisy as all others
    EXPECT_NEAR(tileWelchTest(image(student), image(reference)).tileMde / full, 1, 0.1);
    const std::vector<MomentSummary> black(kPixels, {16.0, 0.0, 0.0, 0.0});
    EXPECT_EQ(tileWelchTest(image(black), image(black)).tileMde, 0);
}

TEST(TileWelch, RefusesImagesThatDoNotMatch) {
    const std::vector<MomentSummary> pixels(kPixels, {16.0, 1.0, 0.0, 0.0});
    EXPECT_THROW(tileWelchTest(image(pixels), {8, 8, pixels}), std::invalid_argument);
    EXPECT_THROW(tileWelchTest({0, 0, {}}, {0, 0, {}}), std::invalid_argument);
    const std::vector<MomentSummary> single(kPixels, {1.0, 1.0, 0.0, 0.0});
    EXPECT_THROW(tileWelchTest(image(single), image(single)), std::invalid_argument);
}

TEST(EstimateScale, RecoversAFactorWithoutTheReferencesBias) {
    const auto student = render(64, 1, [](int, int) { return 1.05; });
    const auto halfA = render(64, 2, right);
    const auto halfB = render(64, 3, right);
    const ScaleEstimate estimate = estimateScale(image(student), image(halfA), image(halfB));
    EXPECT_NEAR(estimate.beta, 0.05, 4.0 * estimate.standardError);
    EXPECT_LT(estimate.standardError, 0.01);
    EXPECT_GT(estimate.bound, estimate.beta);
    const std::vector<MomentSummary> black(kPixels, {16.0, 0.0, 0.0, 0.0});
    EXPECT_THROW(estimateScale(image(student), image(black), image(black)), std::invalid_argument);
}
