// SPDX-License-Identifier: MIT
#pragma once

#include <statistics/mean_tests.h>

#include <cstddef>
#include <span>
#include <vector>

namespace statistics {

/// Per-pixel moments of independent, unfiltered samples of one channel.
struct MomentImage {
    int width = 0;
    int height = 0;
    std::span<const MomentSummary> pixels; ///< shape [height * width], rows from the top

    [[nodiscard]] const MomentSummary &at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
};

struct TileWelchConfig {
    int tileSize = 8; ///< pixels; tiles at the right and lower edge may be smaller
    /// Tiles without variance on either side are compared exactly, up to this part of the larger
    /// of the two means (rounding of a differently written expression).
    double exactTolerance = 1e-4;
    /// Tile differences are related to max(reference, this part of the image's mean).
    double relativeFloor = 0.05;
    /// Leave tiles beyond the skewness gate out of the statistics: for images that nobody can add
    /// samples to. Otherwise `gateMet` tells that more samples are needed.
    bool leavesOutSkewedTiles = false;
    double significance = 1e-4; ///< for the minimal detectable errors, two-sided
    double power = 0.999;       ///< for the minimal detectable errors
    double boundLevel = 1e-4;   ///< of the upper confidence bounds
};

struct Tile {
    int x = 0; ///< of the upper left pixel
    int y = 0;
    double reference = 0.0; ///< mean of the reference
    MeanTestResult test;    ///< student minus reference
    double score = 0.0;     ///< standard normal score of the Hall-transformed deviation
};

struct TileWelchResult {
    std::vector<Tile> tiles; ///< rows from the top
    int tilesX = 0;
    int tilesY = 0;
    MeanTestResult global; ///< mean over the image; sees a common factor
    double referenceMean = 0.0;

    /// Tiles with noise or with a difference; the others say nothing. Without those left out.
    std::size_t tilesTested = 0;
    double sumOfSquares = 0.0; ///< of the scores; sees many weak errors of either sign
    double sumPValue = 1.0;    ///< against chi^2 with one degree of freedom per tested tile
    double maxPValue = 1.0;    ///< largest |score|, Bonferroni over the tiles; sees one bad tile
    std::size_t worstTile = 0; ///< index of the largest |score|
    double pValue = 1.0;       ///< of the three together: min(1, 3 min p)

    bool gateMet = true; ///< skewness low enough in the image mean and in all tiles
    std::size_t tilesBeyondGate = 0;
    double globalRelativeError = 0.0; ///< global difference / mean of the reference
    double globalBound = 0.0;         ///< upper confidence bound of |globalRelativeError|
    double tileBound = 0.0; ///< the largest upper bound of a tile's relative error, Bonferroni
    double globalMde = 0.0; ///< minimal detectable relative error of the image mean
    double tileMde = 0.0; ///< of a tile with median noise of those with any, Bonferroni over tiles
};

/// Compares two images by the means of tiles, with Hall's correction for skewness.
///
/// The variance between pixels never enters: it is a property of the scene. A hole (no variance on
/// one side) is seen like any other difference.
///
/// \throws std::invalid_argument  if the sizes differ, do not match the pixels, are 0, or a pixel
///                                has fewer than 2 samples or a moment that is not finite.
TileWelchResult tileWelchTest(const MomentImage &student, const MomentImage &reference,
                              const TileWelchConfig &config = {});

/// Fills in everything but the tiles, their grid, `global` and `referenceMean`, which are given.
/// Tiles need their place, reference and test; their scores are computed.
void summarizeTiles(TileWelchResult &result, const TileWelchConfig &config);

/// "Your image is (1 + beta) times the reference."
struct ScaleEstimate {
    double beta = 0.0; ///< relative error; -1/2, 1, 1/pi - 1, ... name a mistake
    double standardError = 0.0;
    double bound = 0.0; ///< upper confidence bound of |beta|
    double mde = 0.0;   ///< minimal detectable |beta|
};

/// Weighted estimate of a common factor of what is estimated with noise from a student's image and
/// two independent halves of the reference. Weights and signal come from half A, differences from
/// half B: from one and the same noisy reference beta would be biased by the noise's relative
/// variance.
///
/// \throws std::invalid_argument  as tileWelchTest(), or if the reference is black.
ScaleEstimate estimateScale(const MomentImage &student, const MomentImage &referenceA,
                            const MomentImage &referenceB, const TileWelchConfig &config = {});

} // namespace statistics
