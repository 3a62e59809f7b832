// SPDX-License-Identifier: MIT
#pragma once

#include <statistics/tile_welch.h>

namespace statistics {

/// Nori's default film: a Gaussian less its value at the radius, tabulated, and normalised by the
/// weights that a pixel has got. Samples lie uniformly in their pixels and count for all pixels
/// within the radius.
struct GaussianFilm {
    double radius = 2.0; ///< [pixels]
    double stddev = 0.5; ///< [pixels]

    [[nodiscard]] double weight(double distance) const;
};

/// One channel of two renders that passed through one film. Only the first has moments of its
/// samples; the second is taken to be made by an estimator with the same.
struct FilteredPair {
    MomentImage moments;              ///< of the unfiltered samples of the first render
    std::span<const float> image;     ///< the first through the film, shape [height * width]
    std::span<const float> reference; ///< the second through the film
    double referenceCount = 0.0;      ///< samples per pixel of the second
};

/// As tileWelchTest(), for images whose pixels share samples. The variance of a tile's mean is
/// added up over the pixels q with n samples each: with w the weight with which a sample at a place
/// in q counts for the tile, and r = sum of w_p (mean of q - pixel p) what it counts for the error
/// of the pixels' own weighted means, it is (mean of w^2 * variance of q + variance of r over the
/// places) / n.
///
/// \throws std::invalid_argument  as tileWelchTest(), or without a `referenceCount` > 0
TileWelchResult filteredTileTest(const FilteredPair &pair, const TileWelchConfig &config = {},
                                 const GaussianFilm &film = {});

} // namespace statistics
