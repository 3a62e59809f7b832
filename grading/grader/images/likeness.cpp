// SPDX-License-Identifier: MIT
#include "likeness.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace grader {

namespace {

using statistics::Tile;
using statistics::TileWelchConfig;
using statistics::TileWelchResult;

constexpr double kGlobalTolerance = 0.01;
constexpr double kTileTolerance = 0.15;
constexpr double kUnknownPart = 0.05;

/// An independent pair's mean squared difference is beyond this level once in 10^6.
constexpr double kNoiseLevel = 1e-6;

constexpr double kStatistics = 3; ///< of each channel: mean, worst tile, sum over the tiles

double testedTiles(const TileWelchResult &result) {
    return static_cast<double>(std::max<std::size_t>(1, result.tilesTested));
}

/// Tiles about which nothing is known to within the tolerance: too skewed or too noisy.
std::size_t unknownTiles(const TileWelchResult &result) {
    const TileWelchConfig config;
    const double floor = config.relativeFloor * std::fabs(result.referenceMean);
    return static_cast<std::size_t>(
        std::count_if(result.tiles.begin(), result.tiles.end(), [&](const Tile &tile) {
            const double bound = statistics::absoluteDifferenceBound(
                tile.test, config.boundLevel / testedTiles(result));
            return !tile.test.gateMet ||
                   bound > kTileTolerance * std::max(std::fabs(tile.reference), floor);
        }));
}

class Judge {
public:
    Judge(Comparison &comparison, double significance)
        : m_comparison(comparison),
          m_level(significance / (kStatistics * static_cast<double>(comparison.channels.size()))) {}

    /// \return  false if the difference may be an artefact of skewed samples
    bool explainDifference() {
        bool isSure = false;
        bool isNoiseAlone = m_comparison.isFiltered;
        for (const ChannelComparison &channel : m_comparison.channels) {
            const TileWelchResult &tiles = *channel.tiles;
            isNoiseAlone = isNoiseAlone && tiles.sumPValue < m_level && isOnlyNoisier(tiles);
            const Tile &worst = tiles.tiles[tiles.worstTile];
            if (tiles.global.pValue < m_level && tiles.global.gateMet) {
                isSure = true;
                say("{}: the mean is {:+.3g} % off.", channel.name,
                    100 * tiles.globalRelativeError);
            }
            if (tiles.maxPValue < m_level) {
                isSure = true;
                say("{}: the tile at ({}, {}) has {:.5g} instead of {:.5g} (z = {:+.1f}).",
                    channel.name, worst.x, worst.y, worst.reference + worst.test.difference,
                    worst.reference, worst.score);
            }
            if (tiles.sumPValue < m_level) {
                isSure = true;
                say("{}: the tiles differ by {:.2f} times what noise makes.", channel.name,
                    std::sqrt(tiles.sumOfSquares / testedTiles(tiles)));
            }
        }
        if (isNoiseAlone && m_comparison.apparentCount > 0)
            say("It may be noise alone: with about {:.0f} samples per pixel in the reference, not "
                "{:.0f}, nothing stands out.",
                m_comparison.apparentCount, m_comparison.referenceCount);
        if (!isSure)
            say("They differ, but only where samples are too skewed for so few of them to be "
                "judged: render with more.");
        return isSure;
    }

    /// \return  false if the images are too noisy for "alike", or not independent
    bool explainLikeness() {
        bool isSure = true;
        const auto doubt = [&](const auto &...words) {
            say(words...);
            isSure = false;
        };
        double globalBound = 0;
        std::size_t unknown = 0;
        for (const ChannelComparison &channel : m_comparison.channels) {
            globalBound = std::max(globalBound, channel.tiles->globalBound);
            unknown = std::max(unknown, unknownTiles(*channel.tiles));
            if (channel.noise && channel.noise->z < 0 && channel.noise->pValue < kNoiseLevel)
                doubt("{}: the squared difference is {:.2g} times what independent noise makes: "
                      "the images share samples (the same seed?), or one was smoothed.",
                      channel.name, channel.noise->ratio);
        }
        const std::size_t count = m_comparison.channels.front().tiles->tiles.size();
        if (globalBound > kGlobalTolerance)
            doubt("Too noisy: the mean may still be {:.2g} % off; render with more samples.",
                  100 * globalBound);
        if (static_cast<double>(unknown) > kUnknownPart * static_cast<double>(count))
            doubt("Too noisy: {} of {} tiles may still be {:.2g} % off; render with more samples.",
                  unknown, count, 100 * kTileTolerance);
        if (isSure)
            say("No difference found: the mean is less than {:.2g} % off, a tile less than {:.2g} "
                "%, but for {} of {} tiles that are too noisy or too skewed to tell.",
                100 * globalBound, 100 * kTileTolerance, unknown, count);
        return isSure;
    }

private:
    /// Whether nothing stands out once the noise is taken for what the tiles make it.
    bool isOnlyNoisier(const TileWelchResult &tiles) const {
        const double noise = std::sqrt(tiles.sumOfSquares / testedTiles(tiles));
        const auto isUsual = [&](double z, double tests) {
            return tests * std::erfc(std::fabs(z) / noise / std::sqrt(2.0)) >= m_level;
        };
        return isUsual(tiles.tiles[tiles.worstTile].score, testedTiles(tiles)) &&
               isUsual(tiles.global.hall, 1);
    }

    template <typename... Words>
    void say(const char *text, const Words &...words) {
        m_comparison.reasons.push_back(fmt::format(fmt::runtime(text), words...));
    }

    Comparison &m_comparison;
    double m_level;
};

} // namespace

const char *likenessName(Likeness likeness) {
    switch (likeness) {
    case Likeness::Alike:
        return "alike";
    case Likeness::Different:
        return "different";
    case Likeness::CannotTell:
        break;
    }
    return "cannot tell";
}

void judge(Comparison &comparison, double significance) {
    double smallest = 1;
    for (const ChannelComparison &channel : comparison.channels)
        smallest = std::min(smallest, channel.tiles->pValue);
    comparison.pValue = std::min(1.0, static_cast<double>(comparison.channels.size()) * smallest);
    Judge judge(comparison, significance);
    if (*comparison.pValue < significance)
        comparison.likeness =
            judge.explainDifference() ? Likeness::Different : Likeness::CannotTell;
    else
        comparison.likeness = judge.explainLikeness() ? Likeness::Alike : Likeness::CannotTell;
}

} // namespace grader
