// SPDX-License-Identifier: MIT
#pragma once

#include <grader/checks/radiance_samples.h>
#include <statistics/triple_lock.h>

#include <cstddef>
#include <vector>

namespace grader {

/// A stage takes up to this many looks at samples that double; each has its part of the level.
constexpr int kLooks = 7;

/// Errors that rounding, or a shadow segment shortened in another way, may cause. A statistic
/// counts only where its effect is larger.
constexpr double kGlobalTolerance = 1e-3;
constexpr double kTileTolerance = 1e-2;

/// All three channels of two images, compared.
struct Comparison {
    statistics::StageResult stage; ///< effect: the larger of global error and rms error of tiles
    double factor = 1;             ///< student / expected, over all channels
    double factorError = 0;        ///< standard error of `factor`
    double tileBound = 0;          ///< upper bound of the worst tile's relative error, Bonferroni
};

/// Global scale, sum of squares and worst tile per channel, with skewness correction and gate
/// (statistics.md §2b); a statistic whose gate is not met is not used.
///
/// \param columns   places stand in rows of this many
/// \param tileSize  places per side of a tile
Comparison compareImages(const RadianceMoments &student, const RadianceMoments &expected,
                         int columns, int tileSize);

/// Places where two images differ most, for a second look with fresh samples.
struct Suspects {
    std::vector<std::size_t> pixels; ///< the worst first
    std::vector<std::size_t> tiles;  ///< places of the worst tiles, tileSize^2 each
    double largest = 0;              ///< |z| of the worst pixel or tile
};

/// The 16 worst pixels and 4 worst tiles by their z, which for single pixels is badly calibrated:
/// good for choosing only.
Suspects findSuspects(const RadianceMoments &student, const RadianceMoments &expected, int columns,
                      int tileSize);

/// Compares chosen places, `perGroup` (a square) at a time, by their worst group.
///
/// \param mean    of the whole image and its channels
/// \param places  of the whole image
/// \return        effect: the wrong groups' error as a part of the whole image
statistics::StageResult compareSuspects(const RadianceMoments &student,
                                        const RadianceMoments &expected, int perGroup, double mean,
                                        std::size_t places);

} // namespace grader
