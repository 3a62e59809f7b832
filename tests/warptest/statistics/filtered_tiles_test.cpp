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

/// Nori's film, written down once more.
class Film {
public:
    Film(int width, int height)
        : m_width(width),
          m_height(height),
          m_sums(static_cast<std::size_t>(width * height), 0.0),
          m_weights(m_sums.size(), 0.0) {}

    /// A sample somewhere in the pixel (x, y).
    void put(int x, int y, double value, Random &random) {
        const double u = x + random.nextDouble();
        const double v = y + random.nextDouble();
        for (int py = std::max(0, y - 2); py <= std::min(m_height - 1, y + 2); ++py) {
            for (int px = std::max(0, x - 2); px <= std::min(m_width - 1, x + 2); ++px) {
                const double w =
                    m_film.weight(std::fabs(u - px - 0.5)) * m_film.weight(std::fabs(v - py - 0.5));
                m_sums[static_cast<std::size_t>(py * m_width + px)] += w * value;
                m_weights[static_cast<std::size_t>(py * m_width + px)] += w;
            }
        }
    }

    std::vector<float> image() const {
        std::vector<float> pixels;
        for (std::size_t i = 0; i < m_sums.size(); ++i)
            pixels.push_back(static_cast<float>(m_sums[i] / m_weights[i]));
        return pixels;
    }

private:
    GaussianFilm m_film;
    int m_width;
    int m_height;
    std::vector<double> m_sums;
    std::vector<double> m_weights;
};

/// A render of a field of exponential samples through a Gaussian film, as nori makes one.
struct Render {
    std::vector<MomentSummary> moments;
    std::vector<float> film;
};

/// \param brightness  factor on the samples of the pixels of one tile, (8, 8) to (15, 15)
Render render(std::uint64_t seed, double brightness = 1, int samples = kSamples) {
    Film film(kWidth, kHeight);
    Random random(seed);
    std::vector<RunningMoments> moments(kWidth * kHeight);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const double scale = (1 + 0.02 * x) * (x / 8 == 1 && y / 8 == 1 ? brightness : 1);
            for (int s = 0; s < samples; ++s) {
                const double value = -scale * std::log(1 - random.nextDouble());
                moments[static_cast<std::size_t>(y * kWidth + x)].add(value);
                film.put(x, y, value, random);
            }
        }
    }
    Render result{{}, film.image()};
    for (const RunningMoments &pixel : moments)
        result.moments.push_back(pixel.summary());
    return result;
}

TileWelchResult test(const Render &image, const Render &reference,
                     int referenceSamples = kSamples) {
    return filteredTileTest({{kWidth, kHeight, image.moments},
                             image.film,
                             reference.film,
                             static_cast<double>(referenceSamples)});
}

// As ImageBlock::put(): 32 steps up to the radius of 2, each with the value at its inner end.
TEST(GaussianFilm, IsTabulatedAsInNori) {
    const GaussianFilm film;
    const double end = std::exp(-8.0);
    EXPECT_DOUBLE_EQ(film.weight(0), 1 - end);
    EXPECT_DOUBLE_EQ(film.weight(0.0624), 1 - end);
    EXPECT_DOUBLE_EQ(film.weight(0.0626), std::exp(-2 * 0.0625 * 0.0625) - end);
    EXPECT_DOUBLE_EQ(film.weight(1.03), std::exp(-2.0) - end);
    EXPECT_EQ(film.weight(2), 0);
}

// A step from 0 to 100 at a pixel's edge, without any noise in a sample: all that is left is where
// the samples of the pixels at the step lie.
TEST(FilteredTileTest, KnowsWhatTheFilmMakesOfAStep) {
    constexpr int kRuns = 200;
    constexpr int kSide = 24;
    RunningMoments means;
    double predicted = 0;
    for (std::uint64_t run = 0; run < kRuns; ++run) {
        Film film(kSide, kSide);
        Random random(run);
        std::vector<MomentSummary> moments;
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
                const double value = x < 12 ? 0 : 100;
                moments.push_back({kSamples, value, 0, 0});
                for (int s = 0; s < kSamples; ++s)
                    film.put(x, y, value, random);
            }
        }
        const std::vector<float> image = film.image();
        // the reference has so many samples that it adds no noise
        const Tile tile = filteredTileTest({{kSide, kSide, moments}, image, image, 1e12}).tiles[4];
        EXPECT_EQ(tile.x, 8);
        EXPECT_EQ(tile.y, 8);
        means.add(tile.reference);
        predicted += tile.test.standardError * tile.test.standardError / kRuns;
    }
    // 200 runs know a variance to within 10 %; 4.9 deviations
    EXPECT_NEAR(means.summary().variance / predicted, 1, 0.49);
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
