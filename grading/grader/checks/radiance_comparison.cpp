// SPDX-License-Identifier: MIT
#include "radiance_comparison.h"

#include <statistics/tile_welch.h>

#include <algorithm>
#include <cmath>

namespace grader {

namespace {

using statistics::MomentImage;
using statistics::MomentSummary;
using statistics::Tile;
using statistics::TileWelchResult;

constexpr std::size_t kSuspectPixels = 16;
constexpr std::size_t kSuspectTiles = 4;
/// Relative, of a single pixel or tile: edges of shadows depend on how segments are shortened.
constexpr double kSuspectTolerance = 0.1;
/// Relative to the image's mean: what is darker is compared with this.
constexpr double kDarkest = 0.05;
/// Of the bounds of a look, two-sided: 1e-3 shared by the looks.
constexpr double kBoundLevel = 1e-3 / kLooks;
/// What one statistic has to reach for a first stage to reject: 1e-4 is shared by the looks, two
/// references, three channels and three statistics. The minimal detectable error is that of this.
constexpr double kStatisticLevel = 1e-4 / (kLooks * 2 * 3 * 3);

MomentImage imageOf(const std::vector<MomentSummary> &places, int columns) {
    return {columns, static_cast<int>(places.size()) / columns, places};
}

double scaleOf(const Tile &tile, const TileWelchResult &result) {
    return std::max(tile.reference, kDarkest * result.referenceMean);
}

/// Rms relative deviation of the tiles, noise taken off.
double rmsTileError(const TileWelchResult &result) {
    double sum = 0;
    for (const Tile &tile : result.tiles) {
        const double scale = scaleOf(tile, result);
        if (scale > 0)
            sum += (tile.test.difference * tile.test.difference -
                    tile.test.standardError * tile.test.standardError) /
                   (scale * scale);
    }
    return std::sqrt(std::max(0.0, sum / static_cast<double>(result.tiles.size())));
}

double relativeError(const Tile &tile, const TileWelchResult &result) {
    const double scale = scaleOf(tile, result);
    if (scale > 0)
        return std::abs(tile.test.difference) / scale;
    return tile.test.difference != 0 ? 1 : 0;
}

/// Deviation in standard errors; large where there is a difference and no noise.
double pixelScore(const MomentSummary &a, const MomentSummary &b, double scale) {
    const double difference = std::abs(a.mean - b.mean);
    if (difference <= kSuspectTolerance * std::max(b.mean, kDarkest * scale))
        return 0;
    const double variance = a.variance / a.count + b.variance / b.count;
    return variance > 0 ? difference / std::sqrt(variance) : 1e3;
}

/// Indices of the `wanted` largest scores.
std::vector<std::size_t> largest(const std::vector<double> &scores, std::size_t wanted) {
    std::vector<std::size_t> order(scores.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    const std::size_t count = std::min(wanted, order.size());
    std::partial_sort(order.begin(), order.begin() + static_cast<long>(count), order.end(),
                      [&](std::size_t a, std::size_t b) { return scores[a] > scores[b]; });
    order.resize(count);
    return order;
}

} // namespace

Comparison compareImages(const RadianceMoments &student, const RadianceMoments &expected,
                         int columns, int tileSize) {
    Comparison result;
    statistics::StageResult &stage = result.stage;
    stage.effectBound = 0;
    double studentSum = 0;
    double expectedSum = 0;
    double varianceSum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const TileWelchResult found =
            statistics::tileWelchTest(imageOf(student[c], columns), imageOf(expected[c], columns),
                                      {.tileSize = tileSize,
                                       .relativeFloor = kDarkest,
                                       .significance = kStatisticLevel,
                                       .boundLevel = kBoundLevel});
        const double rms = rmsTileError(found);
        const double worst = relativeError(found.tiles[found.worstTile], found);
        const double global = std::abs(found.globalRelativeError);
        double p = 1;
        if (found.global.gateMet && global > kGlobalTolerance)
            p = std::min(p, 3 * found.global.pValue);
        if (found.gateMet && rms > kTileTolerance)
            p = std::min(p, 3 * found.sumPValue);
        if (found.gateMet && worst > kTileTolerance)
            p = std::min(p, 3 * found.maxPValue);
        stage.pValue = std::min(stage.pValue, 3 * p);
        stage.effect = std::max({stage.effect, global, rms});
        stage.effectBound = std::max(stage.effectBound, found.globalBound);
        stage.mde = std::max(stage.mde, found.globalMde);
        stage.z = std::max(stage.z, std::abs(found.global.z));
        stage.reliable = stage.reliable && found.global.gateMet;
        result.tileBound = std::max(result.tileBound, found.tileBound);
        for (const Tile &tile : found.tiles) {
            stage.z = std::max(stage.z, std::abs(tile.score));
            stage.deviation.push_back(std::clamp(tile.score, -1e6, 1e6));
        }
        studentSum += found.global.difference + found.referenceMean;
        expectedSum += found.referenceMean;
        varianceSum += found.global.standardError * found.global.standardError;
    }
    if (expectedSum > 0) {
        result.factor = studentSum / expectedSum;
        result.factorError = std::sqrt(varianceSum) / expectedSum;
    }
    return result;
}

Suspects findSuspects(const RadianceMoments &student, const RadianceMoments &expected, int columns,
                      int tileSize) {
    Suspects result;
    std::vector<double> pixels(student[0].size());
    std::vector<double> tiles;
    int tilesX = 1;
    for (std::size_t c = 0; c < 3; ++c) {
        const TileWelchResult found = statistics::tileWelchTest(
            imageOf(student[c], columns), imageOf(expected[c], columns), {.tileSize = tileSize});
        tilesX = found.tilesX;
        tiles.resize(found.tiles.size());
        for (std::size_t i = 0; i < tiles.size(); ++i) {
            if (relativeError(found.tiles[i], found) > kSuspectTolerance)
                tiles[i] = std::max(tiles[i], std::abs(found.tiles[i].score));
        }
        for (std::size_t i = 0; i < pixels.size(); ++i)
            pixels[i] =
                std::max(pixels[i], pixelScore(student[c][i], expected[c][i], found.referenceMean));
    }
    result.pixels = largest(pixels, kSuspectPixels);
    const auto width = static_cast<std::size_t>(columns);
    const auto side = static_cast<std::size_t>(tileSize);
    const std::size_t rows = pixels.size() / width;
    for (const std::size_t tile : largest(tiles, kSuspectTiles)) {
        const std::size_t x = tile % static_cast<std::size_t>(tilesX) * side;
        const std::size_t y = tile / static_cast<std::size_t>(tilesX) * side;
        if (x + side > width || y + side > rows)
            continue; // a smaller one at the edge: its pixels have their chance alone
        for (std::size_t i = 0; i < side * side; ++i)
            result.tiles.push_back((y + i / side) * width + x + i % side);
    }
    result.largest = std::max(*std::max_element(pixels.begin(), pixels.end()),
                              *std::max_element(tiles.begin(), tiles.end()));
    return result;
}

statistics::StageResult compareSuspects(const RadianceMoments &student,
                                        const RadianceMoments &expected, int perGroup, double mean,
                                        std::size_t places) {
    statistics::StageResult result;
    result.effectBound = 0; // what is not rejected here stays what it was
    const int side = static_cast<int>(std::lround(std::sqrt(perGroup)));
    double wrong = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const TileWelchResult found = statistics::tileWelchTest(
            imageOf(student[c], side), imageOf(expected[c], side), {.tileSize = side});
        const double tests = 3 * static_cast<double>(found.tiles.size());
        for (const Tile &group : found.tiles) {
            const double scale = std::max(group.reference, kDarkest * mean);
            const double error = std::abs(group.test.difference);
            const bool counts = group.test.gateMet && error > kSuspectTolerance * scale;
            result.deviation.push_back(std::clamp(group.score, -1e6, 1e6));
            if (!counts)
                continue;
            const double p = std::min(1.0, tests * group.test.pValue);
            result.pValue = std::min(result.pValue, p);
            result.z = std::max(result.z, std::abs(group.score));
            if (p < 1e-4)
                wrong += perGroup * error;
        }
    }
    result.effect = mean > 0 ? wrong / (3 * mean * static_cast<double>(places)) : 1;
    return result;
}

} // namespace grader
