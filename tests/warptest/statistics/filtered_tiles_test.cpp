// SPDX-License-Identifier: MIT
#include <statistics/filtered_tiles.h>
#include <statistics/random.h>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace statistics {
namespace {

constexpr int kWidth = 40;
constexpr int kHeight = 32;
constexpr int kSamples = 16;

/// A render of a field of exponential samples through a Gaussian film, as nori makes one.
struct Render {
    std::vector<MomentSummary> moments;
    std::vector<float> film;
};

/// \param brightness  factor on the samples of the pixels of one tile, (8, 8) to (15, 15)
Render render(std::uint64_t seed, double brightness = 1, int samples = kSamples) {
    const GaussianFilm film;
    Random random(seed);
    std::vector<RunningMoments> moments(kWidth * kHeight);
    std::vector<double> sums(kWidth * kHeight, 0.0);
    std::vector<double> weights(kWidth * kHeight, 0.0);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const double scale = (1 + 0.02 * x) * (x / 8 == 1 && y / 8 == 1 ? brightness : 1);
            for (int s = 0; s < samples; ++s) {
                const double u = x + random.nextDouble();
                const double v = y + random.nextDouble();
                const double value = -scale * std::log(1 - random.nextDouble());
                moments[static_cast<std::size_t>(y * kWidth + x)].add(value);
                for (int py = std::max(0, y - 2); py <= std::min(kHeight - 1, y + 2); ++py) {
                    for (int px = std::max(0, x - 2); px <= std::min(kWidth - 1, x + 2); ++px) {
                        const double w = film.weight(std::fabs(u - px - 0.5)) *
                                         film.weight(std::fabs(v - py - 0.5));
                        sums[static_cast<std::size_t>(py * kWidth + px)] += w * value;
                        weights[static_cast<std::size_t>(py * kWidth + px)] += w;
                    }
                }
            }
        }
    }
    Render result;
    for (std::size_t i = 0; i < moments.size(); ++i) {
        result.moments.push_back(moments[i].summary());
        result.film.push_back(static_cast<float>(sums[i] / weights[i]));
    }
    return result;
}

TileWelchResult test(const Render &image, const Render &reference,
                     int referenceSamples = kSamples) {
    return filteredTileTest({{kWidth, kHeight, image.moments},
                             image.film,
                             reference.film,
                             static_cast<double>(referenceSamples)});
}

TEST(FilteredTileTest, ScoresTilesOfIndependentRendersAsStandardNormal) {
    // 30 pairs of 20 tiles; the mean of 600 z^2 has deviation sqrt(2 / 600) = 0.058 (4.9: 0.28),
    // and neighbours are correlated a little.
    double sum = 0;
    int count = 0;
    for (std::uint64_t run = 0; run < 30; ++run) {
        for (const Tile &tile : test(render(2 * run), render(2 * run + 1)).tiles) {
            sum += tile.score * tile.score;
            ++count;
        }
    }
    EXPECT_EQ(count, 600);
    EXPECT_NEAR(sum / count, 1, 0.28);
}

TEST(FilteredTileTest, KnowsThatMoreSamplesMakeLessNoise) {
    double sum = 0;
    for (std::uint64_t run = 0; run < 20; ++run) {
        const TileWelchResult result =
            test(render(2 * run), render(2 * run + 1, 1, 4 * kSamples), 4 * kSamples);
        sum += result.sumOfSquares / static_cast<double>(20 * result.tiles.size());
    }
    EXPECT_NEAR(sum, 1, 0.35); // 4.9 deviations of 400 z^2
}

TEST(FilteredTileTest, FindsABrightTile) {
    // A tile of 64 pixels of 16 samples: relative error of the difference about 1.4 / 32 = 0.044;
    // 40 % is 9 deviations. The level is 1e-4.
    const TileWelchResult result = test(render(1, 1.4), render(2));
    EXPECT_LT(result.maxPValue, 1e-4);
    EXPECT_EQ(result.tiles[result.worstTile].x, 8);
    EXPECT_EQ(result.tiles[result.worstTile].y, 8);
    EXPECT_GT(test(render(1), render(2)).maxPValue, 1e-4);
}

TEST(FilteredTileTest, FindsAHoleAndForgivesRounding) {
    Render black = render(1);
    black.moments.assign(black.moments.size(), {kSamples, 0, 0, 0});
    black.film.assign(black.film.size(), 0.0F);
    EXPECT_EQ(test(black, render(2)).pValue, 0);
    Render flat = black;
    flat.moments.assign(flat.moments.size(), {kSamples, 20, 0, 0});
    flat.film.assign(flat.film.size(), 20.0F);
    Render rounded = flat;
    rounded.film.assign(flat.film.size(), 20.0001F);
    EXPECT_EQ(test(flat, rounded).pValue, 1);
}

TEST(FilteredTileTest, RefusesImagesThatDoNotFit) {
    const Render image = render(1);
    const MomentImage moments{kWidth, kHeight, image.moments};
    EXPECT_THROW(filteredTileTest({moments, image.film, {}, 16}), std::invalid_argument);
    EXPECT_THROW(filteredTileTest({moments, image.film, image.film, 0}), std::invalid_argument);
    EXPECT_THROW(filteredTileTest({{kWidth, 3, image.moments}, image.film, image.film, 16}),
                 std::invalid_argument);
}

} // namespace
} // namespace statistics
