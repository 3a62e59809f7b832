// SPDX-License-Identifier: MIT
#pragma once

#include <battery/domain_map.h>

#include <cstddef>
#include <span>
#include <vector>

namespace battery {

/// Observed and expected numbers of points in the cells of a domain map, shape [side, side],
/// row 0 at the map's lower edge.
struct Maps {
    DomainMap domain;
    int side = 0; ///< columns, and rows
    std::size_t points = 0;
    std::size_t outside = 0; ///< points in no cell
    std::vector<double> observed;
    std::vector<double> expected; ///< by the exact density
    /// (observed - expected) / sqrt(expected); 0 where less than kMinExpected are expected and no
    /// more than a few are there: those say nothing alone.
    std::vector<double> residual;
    std::vector<bool> sparse; ///< cells without a residual
    double largest = 0.0;     ///< of observed and expected, for a common colour bar
};

inline constexpr int kMapSide = 32; ///< where nothing else is asked for
inline constexpr int kMinMapSide = 4;
inline constexpr int kMaxMapSide = 128;
inline constexpr double kMinExpected = 5.0;

/// Counts of points in the cells of a domain map, shape [side, side]; those outside are left out.
std::vector<double> countCells(const DomainMap &domain, std::span<const Output> outputs, int side);

/// \param outputs  of independent inputs: with others the residuals are smaller than chance allows
/// \param side     in [kMinMapSide, kMaxMapSide]
Maps makeMaps(const catalog::WarpEntry &truth, double a, std::span<const Output> outputs,
              int side = kMapSide);

/// The same of counts that were made earlier. \throws std::invalid_argument  if they are no square
Maps mapsOfCounts(const catalog::WarpEntry &truth, double a, std::vector<double> observed,
                  std::size_t points);

/// Index of the cell with the largest |residual|; 0 if there is none.
std::size_t worstCell(const Maps &maps);

/// The cell of a map that a place of [0, 1]^2 is in; its index, or -1 outside.
int cellAt(const std::array<double, 2> &place, int side);

} // namespace battery
