// SPDX-License-Identifier: MIT
#include "tile_welch.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace statistics {

namespace {

void requireImage(const MomentImage &image, const MomentImage &like) {
    if (image.width <= 0 || image.height <= 0 || image.width != like.width ||
        image.height != like.height ||
        image.pixels.size() !=
            static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height)) {
        throw std::invalid_argument("tileWelchTest: images must have one size and all pixels");
    }
    for (const MomentSummary &pixel : image.pixels) {
        if (!(pixel.count >= 2.0) || !std::isfinite(pixel.mean) || !std::isfinite(pixel.variance) ||
            !std::isfinite(pixel.thirdCentral)) {
            throw std::invalid_argument(
                "tileWelchTest: a pixel has fewer than 2 samples or moments that are not finite");
        }
    }
}

/// Sums over pixels of what a Welch test of their mean needs.
struct DifferenceSums {
    double pixels = 0.0;
    double student = 0.0;
    double reference = 0.0;
    double variance = 0.0;
    double thirdCentral = 0.0;
    double welchDenominator = 0.0;

    void addSide(const MomentSummary &pixel, double sign) {
        const double variancePart = pixel.variance / pixel.count;
        variance += variancePart;
        thirdCentral += sign * pixel.thirdCentral / (pixel.count * pixel.count);
        welchDenominator += variancePart * variancePart / (pixel.count - 1.0);
    }

    void add(const MomentSummary &a, const MomentSummary &b) {
        pixels += 1.0;
        student += a.mean;
        reference += b.mean;
        addSide(a, 1.0);
        addSide(b, -1.0);
    }

    [[nodiscard]] MeanTestResult test(double exactTolerance) const {
        double difference = (student - reference) / pixels;
        const double larger = std::max(std::fabs(student), std::fabs(reference)) / pixels;
        if (variance == 0.0 && std::fabs(difference) <= exactTolerance * larger) {
            difference = 0.0;
        }
        const double degreesOfFreedom =
            welchDenominator > 0.0 ? variance * variance / welchDenominator : 1.0;
        return meanTest(difference, variance / (pixels * pixels),
                        thirdCentral / (pixels * pixels * pixels), degreesOfFreedom);
    }
};

/// The standard normal deviate with the p-value of a t-distributed one.
double normalScore(const MeanTestResult &test) {
    if (test.standardError == 0.0) {
        return test.difference == 0.0 ? 0.0 : std::copysign(1e3, test.difference);
    }
    if (test.degreesOfFreedom > 1e4 || test.pValue < 1e-290) {
        return test.hall;
    }
    const double tail = std::min(0.5, 0.5 * test.pValue);
    return std::copysign(quantile(complement(boost::math::normal(), tail)), test.hall);
}

double bound(const MeanTestResult &test, double level) {
    return absoluteDifferenceBound(test, level);
}

void combine(TileWelchResult &result, bool leavesOutSkewedTiles) {
    const boost::math::normal normal;
    double largest = -1.0;
    for (std::size_t i = 0; i < result.tiles.size(); ++i) {
        const Tile &tile = result.tiles[i];
        if (!tile.test.gateMet) {
            ++result.tilesBeyondGate;
            if (leavesOutSkewedTiles)
                continue;
        }
        result.sumOfSquares += tile.score * tile.score;
        if (std::fabs(tile.score) > largest) {
            largest = std::fabs(tile.score);
            result.worstTile = i;
        }
        // A tile without noise that agrees can neither raise an alarm nor hide one.
        if (tile.test.standardError > 0.0 || tile.score != 0.0)
            ++result.tilesTested;
    }
    if (result.tilesTested > 0) {
        const auto count = static_cast<double>(result.tilesTested);
        result.sumPValue = cdf(complement(boost::math::chi_squared(count), result.sumOfSquares));
        result.maxPValue = std::min(1.0, count * 2.0 * cdf(complement(normal, largest)));
    }
    result.pValue =
        std::min(1.0, 3.0 * std::min({result.global.pValue, result.sumPValue, result.maxPValue}));
    result.gateMet = result.global.gateMet && result.tilesBeyondGate == 0;
}

void addEffectSizes(TileWelchResult &result, const TileWelchConfig &config) {
    const auto count = static_cast<double>(result.tiles.size());
    const double mean = std::fabs(result.referenceMean);
    const double unit = mean > 0.0 ? mean : 1.0;
    result.globalRelativeError = result.global.difference / unit;
    result.globalBound = bound(result.global, config.boundLevel) / unit;
    result.globalMde =
        detectableDifference(result.global.standardError, config.significance, config.power) / unit;
    std::vector<double> relativeNoise;
    for (const Tile &tile : result.tiles) {
        const double tileUnit = std::max(std::fabs(tile.reference), config.relativeFloor * unit);
        result.tileBound =
            std::max(result.tileBound, bound(tile.test, config.boundLevel / count) / tileUnit);
        if (tile.test.standardError > 0.0) // black and flat tiles show every difference
            relativeNoise.push_back(tile.test.standardError / tileUnit);
    }
    if (relativeNoise.empty())
        return;
    const auto middle = relativeNoise.begin() + static_cast<long>(relativeNoise.size() / 2);
    std::nth_element(relativeNoise.begin(), middle, relativeNoise.end());
    result.tileMde = detectableDifference(*middle, config.significance / count, config.power);
}

} // namespace

void summarizeTiles(TileWelchResult &result, const TileWelchConfig &config) {
    for (Tile &tile : result.tiles)
        tile.score = normalScore(tile.test);
    combine(result, config.leavesOutSkewedTiles);
    addEffectSizes(result, config);
}

TileWelchResult tileWelchTest(const MomentImage &student, const MomentImage &reference,
                              const TileWelchConfig &config) {
    requireImage(reference, student);
    requireImage(student, reference);
    if (config.tileSize <= 0) {
        throw std::invalid_argument("tileWelchTest: tileSize must be > 0");
    }
    TileWelchResult result;
    result.tilesX = (student.width + config.tileSize - 1) / config.tileSize;
    result.tilesY = (student.height + config.tileSize - 1) / config.tileSize;
    DifferenceSums all;
    for (int y = 0; y < student.height; y += config.tileSize) {
        for (int x = 0; x < student.width; x += config.tileSize) {
            DifferenceSums sums;
            for (int py = y; py < std::min(student.height, y + config.tileSize); ++py) {
                for (int px = x; px < std::min(student.width, x + config.tileSize); ++px) {
                    sums.add(student.at(px, py), reference.at(px, py));
                    all.add(student.at(px, py), reference.at(px, py));
                }
            }
            result.tiles.push_back(
                {x, y, sums.reference / sums.pixels, sums.test(config.exactTolerance), 0.0});
        }
    }
    result.global = all.test(config.exactTolerance);
    result.referenceMean = all.reference / all.pixels;
    summarizeTiles(result, config);
    return result;
}

ScaleEstimate estimateScale(const MomentImage &student, const MomentImage &referenceA,
                            const MomentImage &referenceB, const TileWelchConfig &config) {
    requireImage(student, referenceA);
    requireImage(referenceA, student);
    requireImage(referenceB, student);
    double meanVariance = 0.0;
    for (const MomentSummary &pixel : referenceA.pixels) {
        meanVariance += pixel.variance / static_cast<double>(referenceA.pixels.size());
    }
    double numerator = 0.0;
    double denominator = 0.0;
    double variance = 0.0;
    for (std::size_t i = 0; i < student.pixels.size(); ++i) {
        const MomentSummary &x = student.pixels[i];
        const MomentSummary &a = referenceA.pixels[i];
        const MomentSummary &b = referenceB.pixels[i];
        if (a.variance == 0.0 && meanVariance > 0.0)
            continue; // what is seen without noise would outweigh all that is estimated
        // The addend keeps a pixel that happens to show little noise from outweighing the rest.
        const double noise = a.variance + 0.1 * meanVariance;
        const double weight = (noise > 0.0 ? 1.0 / noise : 1.0) * a.mean;
        numerator += weight * (x.mean - b.mean);
        denominator += weight * b.mean;
        variance += weight * weight * (x.variance / x.count + b.variance / b.count);
    }
    if (!(denominator > 0.0)) {
        throw std::invalid_argument("estimateScale: the reference is black");
    }
    ScaleEstimate result;
    result.beta = numerator / denominator;
    result.standardError = std::sqrt(variance) / denominator;
    const double q = quantile(complement(boost::math::normal(), config.boundLevel / 2.0));
    result.bound = std::fabs(result.beta) + q * result.standardError;
    result.mde = detectableDifference(result.standardError, config.significance, config.power);
    return result;
}

} // namespace statistics
