// SPDX-License-Identifier: MIT
#pragma once

#include <catalog/warp_entry.h>

#include <functional>

namespace catalog {

/// A domain, laid out on the unit square. One whose coordinates follow the density (its axis, its
/// grid) needs the fewest cells to be integrated over.
struct Chart {
    int dimension = 2; ///< 2: plane, area measure; 3: directions, solid angle
    std::function<Point(const Square &s)> point{};
    std::function<Square(const Point &p)> place{}; ///< inverse; out of [0, 1]^2 out of the domain
    std::function<double(const Square &s)>
        stretch{};  ///< area or solid angle per area of the square
    int uCells = 1; ///< the density is smooth within each cell of such a grid of the square
    int vCells = 1;
};

/// x along u in [low.x, high.x], y along v.
Chart rectangle(const Point &low, const Point &high);

/// Directions around +z with cosines in [lowest, highest]: u along the cosine, v the azimuth.
Chart zone(double lowest, double highest);

/// All directions as in a map in latitude and longitude with +y up and `rows` x `columns` texels:
/// u along the polar angle, v the azimuth around y.
Chart latitudeLongitude(int rows, int columns);

/// The half sphere around +z for a lobe in which tan(theta) is about `width`: u along
/// tan^2 / (tan^2 + width^2), v the azimuth.
Chart lobe(double width);

} // namespace catalog
