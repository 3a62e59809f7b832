// SPDX-License-Identifier: MIT
#pragma once

#include <battery/callables.h>
#include <catalog/chart.h>

#include <cstddef>
#include <functional>
#include <span>
#include <string>

namespace battery {

/// Cells of a table along each coordinate of its chart, at least.
inline constexpr int kTableSide = 512;
/// How far the two rules of integration may differ, and the integral from 1 [relative].
inline constexpr double kTableTolerance = 1e-3;

/// A target that is known by its density alone: its distribution function is tabulated, so that
/// everything in this folder works for it as for a catalogued one.
struct TabulatedTarget {
    catalog::WarpEntry entry; ///< of the density over its integral
    Density density;          ///< as it was given
    /// The density by the table, constant in each of its cells.
    std::function<double(const catalog::Point &p)> tabulated;
    double integral = 0.0;      ///< of the density, cell by cell, refined to 1e-4 of each cell
    double checkIntegral = 0.0; ///< by another rule, at other points
    std::size_t notFinite = 0;  ///< points at which the density was infinite or NaN, taken as 0
    std::size_t negative = 0;   ///< points at which it was negative, taken as 0

    /// The two integrals agree; nothing that is told from them is worth anything if not.
    [[nodiscard]] bool isReliable() const;
};

/// \param density  Per area or solid angle; need not be normalised. It is copied and stays in use.
/// \throws std::invalid_argument  if the density is 0 everywhere that it is looked at
TabulatedTarget tabulateTarget(std::string id, const catalog::Chart &chart, const Density &density);

/// Does the table see what the samples see? Mean of (tabulated density) / (density at the point)
/// over samples that follow that density: 1, whatever it is. A peak between the points that were
/// looked at shows as a lack.
struct ImportanceCheck {
    double mean = 1.0;
    double standardError = 0.0;
    std::size_t unseen = 0; ///< outputs at which the density is 0

    /// Within the tolerance, or within what chance explains (at 1e-4).
    [[nodiscard]] bool agrees() const;
};

/// \param outputs  of independent inputs, at least two
ImportanceCheck checkByImportance(const TabulatedTarget &target, std::span<const Output> outputs);

} // namespace battery
