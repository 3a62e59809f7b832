// SPDX-License-Identifier: MIT
#include "filtered_tiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace statistics {

namespace {

/// Tiles darker than this part of TileWelchConfig::relativeFloor's mean are seen by too few
/// samples.
constexpr double kDark = 2e-3;

/// Nori looks the filter up in a table of this many values up to the radius, always at the one
/// before the distance: its film is 3 % wider than the formula, and takes off 6 % more variance.
constexpr int kSteps = 32;

/// Per axis, at which a sample may lie in its pixel: with the default radius one in the middle of
/// each of the table's steps.
constexpr int kPlaces = 16;

/// Weights of one axis: those of a sample in pixel q at one of the places for the pixels around q,
/// divided by what those pixels get in total per sample of a pixel.
class AxisWeights {
public:
    AxisWeights(const GaussianFilm &film, int size)
        : m_reach(static_cast<int>(std::ceil(film.radius))),
          m_size(size),
          m_width(2 * static_cast<std::size_t>(m_reach) + 1) {
        m_weights.resize(static_cast<std::size_t>(size) * kPlaces * m_width);
        std::vector<double> totals(static_cast<std::size_t>(size), 0.0);
        for (int q = 0; q < size; ++q) {
            for (int place = 0; place < kPlaces; ++place) {
                for (int p = std::max(0, q - m_reach); p <= std::min(size - 1, q + m_reach); ++p) {
                    const double at = q - p + (place + 0.5) / kPlaces - 0.5;
                    ref(q, place, p) = film.weight(std::fabs(at));
                    totals[static_cast<std::size_t>(p)] += ref(q, place, p) / kPlaces;
                }
            }
        }
        for (int q = 0; q < size; ++q) {
            for (int place = 0; place < kPlaces; ++place) {
                for (int p = std::max(0, q - m_reach); p <= std::min(size - 1, q + m_reach); ++p)
                    ref(q, place, p) /= totals[static_cast<std::size_t>(p)];
            }
        }
    }

    [[nodiscard]] double at(int q, int place, int p) const { return m_weights[index(q, place, p)]; }

    [[nodiscard]] int reach() const { return m_reach; }

    [[nodiscard]] int size() const { return m_size; }

private:
    [[nodiscard]] std::size_t index(int q, int place, int p) const {
        const auto sample = static_cast<std::size_t>(q) * kPlaces + static_cast<std::size_t>(place);
        return sample * m_width + static_cast<std::size_t>(p - q + m_reach);
    }

    double &ref(int q, int place, int p) { return m_weights[index(q, place, p)]; }

    int m_reach;
    int m_size;
    std::size_t m_width; ///< pixels that a sample counts for
    std::vector<double> m_weights;
};

/// Pixels [begin, end) of one axis.
struct Interval {
    int begin = 0;
    int end = 0;

    [[nodiscard]] Interval grown(int by, int size) const {
        return {std::max(0, begin - by), std::min(size, end + by)};
    }

    [[nodiscard]] Interval around(int q, int reach) const {
        return {std::max(begin, q - reach), std::min(end, q + reach + 1)};
    }
};

class FilteredTiles {
public:
    /// \param floor  mean above which a render cannot have missed all that there is
    FilteredTiles(const FilteredPair &pair, const GaussianFilm &film, double floor)
        : m_pair(pair),
          m_floor(floor),
          m_x(film, pair.moments.width),
          m_y(film, pair.moments.height) {}

    /// Test of the mean over a rectangle of pixels.
    [[nodiscard]] MeanTestResult test(const Interval &xs, const Interval &ys, double exactTolerance,
                                      double &referenceMean) const {
        const double pixels = static_cast<double>(xs.end - xs.begin) * (ys.end - ys.begin);
        double image = 0.0;
        referenceMean = 0.0;
        for (int y = ys.begin; y < ys.end; ++y) {
            for (int x = xs.begin; x < xs.end; ++x) {
                image += double{m_pair.image[index(x, y)]} / pixels;
                referenceMean += double{m_pair.reference[index(x, y)]} / pixels;
            }
        }
        Noise noise;
        const Interval qys = ys.grown(m_y.reach(), m_y.size());
        const Interval qxs = xs.grown(m_x.reach(), m_x.size());
        for (int qy = qys.begin; qy < qys.end; ++qy) {
            for (int qx = qxs.begin; qx < qxs.end; ++qx)
                addPixel(qx, qy, xs, ys, noise);
        }
        double difference = image - referenceMean;
        const double larger = std::max(std::fabs(image), std::fabs(referenceMean));
        // The film adds up floats: 20 may become 20.0001 in one of two renders.
        constexpr double kRounding = 1e-5;
        const double tolerance = noise.variance == 0.0 ? exactTolerance : kRounding;
        if (std::fabs(difference) <= tolerance * larger)
            difference = 0.0;
        MeanTestResult result =
            meanTest(difference, noise.variance / (pixels * pixels),
                     noise.thirdCentral / (pixels * pixels * pixels), noise.degreesOfFreedom);
        // What the first render has hardly ever seen may still be there, if it is rare enough.
        if (difference != 0.0 && larger < (noise.variance == 0.0 ? m_floor : kDark * m_floor))
            result.gateMet = false;
        return result;
    }

private:
    struct Noise {
        double variance = 0.0; ///< of the sum over the rectangle's pixels
        double thirdCentral = 0.0;
        double degreesOfFreedom = 1e6; ///< hundreds of samples in each of tens of pixels
    };

    /// Sums over a sample's places of powers of the weight that it has for pixels of one axis.
    struct Powers {
        double square = 0.0;
        double cube = 0.0;
    };

    static Powers powersOf(const AxisWeights &axis, int q, const Interval &pixels) {
        Powers powers;
        for (int place = 0; place < kPlaces; ++place) {
            double weight = 0.0;
            for (int p = pixels.begin; p < pixels.end; ++p)
                weight += axis.at(q, place, p);
            powers.square += weight * weight;
            powers.cube += weight * weight * weight;
        }
        return powers;
    }

    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_pair.moments.width) +
               static_cast<std::size_t>(x);
    }

    /// Adds what the samples in pixel (qx, qy) of both renders do to the sum.
    void addPixel(int qx, int qy, const Interval &xs, const Interval &ys, Noise &noise) const {
        const MomentSummary &samples = m_pair.moments.at(qx, qy);
        const Interval pxs = xs.around(qx, m_x.reach());
        const Interval pys = ys.around(qy, m_y.reach());
        constexpr double kAll = kPlaces * kPlaces;
        // What the filter's axes give on their own: all is a product of the two, or a sum of such.
        const Powers inX = powersOf(m_x, qx, pxs);
        const Powers inY = powersOf(m_y, qy, pys);
        double offsets = 0.0;
        double squares = 0.0; ///< of the offsets
        for (int placeX = 0; placeX < kPlaces; ++placeX) {
            std::array<double, kPlaces> offset{};
            for (int py = pys.begin; py < pys.end; ++py) {
                double row = 0.0;
                for (int px = pxs.begin; px < pxs.end; ++px)
                    row += m_x.at(qx, placeX, px) *
                           (samples.mean - double{m_pair.image[index(px, py)]});
                for (int placeY = 0; placeY < kPlaces; ++placeY)
                    offset[static_cast<std::size_t>(placeY)] += m_y.at(qy, placeY, py) * row;
            }
            for (const double value : offset) {
                offsets += value;
                squares += value * value;
            }
        }
        // A pixel has its number of samples, neither more nor less: their mean offset is no noise.
        squares -= offsets * offsets / kAll;
        const double variance = inX.square * inY.square * samples.variance + squares;
        const double third = inX.cube * inY.cube * samples.thirdCentral;
        const double own = 1.0 / samples.count;
        const double other = 1.0 / m_pair.referenceCount;
        noise.variance += variance / kAll * (own + other);
        noise.thirdCentral += third / kAll * (own * own - other * other);
    }

    const FilteredPair &m_pair;
    double m_floor;
    AxisWeights m_x;
    AxisWeights m_y;
};

void requirePair(const FilteredPair &pair) {
    const auto pixels = static_cast<std::size_t>(pair.moments.width) *
                        static_cast<std::size_t>(pair.moments.height);
    if (pair.moments.width <= 0 || pair.moments.height <= 0 || pair.image.size() != pixels ||
        pair.reference.size() != pixels || pair.moments.pixels.size() != pixels)
        throw std::invalid_argument("filteredTileTest: images must have one size and all pixels");
    if (!(pair.referenceCount > 0.0))
        throw std::invalid_argument("filteredTileTest: the reference needs a number of samples");
    const auto isUsable = [](const MomentSummary &pixel) {
        return pixel.count >= 2.0 && std::isfinite(pixel.mean) && std::isfinite(pixel.variance) &&
               std::isfinite(pixel.thirdCentral);
    };
    if (!std::all_of(pair.moments.pixels.begin(), pair.moments.pixels.end(), isUsable))
        throw std::invalid_argument(
            "filteredTileTest: a pixel has fewer than 2 samples or moments that are not finite");
}

} // namespace

double GaussianFilm::weight(double distance) const {
    const double step = std::floor(distance / radius * kSteps);
    const double tabulated = radius * step / kSteps;
    const double exponent = -0.5 / (stddev * stddev);
    return std::max(0.0, std::exp(exponent * tabulated * tabulated) -
                             std::exp(exponent * radius * radius));
}

TileWelchResult filteredTileTest(const FilteredPair &pair, const TileWelchConfig &config,
                                 const GaussianFilm &film) {
    requirePair(pair);
    const int width = pair.moments.width;
    const int height = pair.moments.height;
    const int size = config.tileSize;
    if (size <= 0)
        throw std::invalid_argument("filteredTileTest: tileSize must be > 0");
    double mean = 0.0;
    for (const float value : pair.reference)
        mean += double{value} / static_cast<double>(pair.reference.size());
    const FilteredTiles tiles(pair, film, config.relativeFloor * mean);
    TileWelchResult result;
    result.tilesX = (width + size - 1) / size;
    result.tilesY = (height + size - 1) / size;
    for (int y = 0; y < height; y += size) {
        for (int x = 0; x < width; x += size) {
            Tile tile{x, y, 0.0, {}, 0.0};
            tile.test = tiles.test({x, std::min(width, x + size)}, {y, std::min(height, y + size)},
                                   config.exactTolerance, tile.reference);
            result.tiles.push_back(tile);
        }
    }
    result.global =
        tiles.test({0, width}, {0, height}, config.exactTolerance, result.referenceMean);
    summarizeTiles(result, config);
    return result;
}

} // namespace statistics
