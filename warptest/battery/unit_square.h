// SPDX-License-Identifier: MIT
#pragma once

#include <battery/records.h>

#include <cstddef>
#include <span>
#include <vector>

namespace battery {

/// Outputs mapped to the unit square by the target's distribution function.
struct UnitSquarePoints {
    std::vector<double> u; ///< of the outputs inside the domain, in [0, 1]
    std::vector<double> v;
    std::size_t total = 0;     ///< all outputs
    std::size_t poleAtoms = 0; ///< outputs exactly at the pole, whose V was spread evenly

    /// Outputs not in the domain (not finite, off the unit sphere, outside of the support).
    [[nodiscard]] std::size_t invalid() const { return total - u.size(); }
};

/// Maps outputs; those out of the domain are counted, never clamped into a border cell.
UnitSquarePoints toUnitSquare(const catalog::WarpEntry &entry, double a,
                              std::span<const Output> outputs);

/// Counts in `uBins` x `vBins` equal cells, u slowest.
std::vector<double> countCells(const UnitSquarePoints &points, int uBins, int vBins);

} // namespace battery
