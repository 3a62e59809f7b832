// SPDX-License-Identifier: MIT
#pragma once

#include <battery/records.h>

#include <span>

namespace battery {

/// Largest gap between neighbouring values of a coordinate.
struct StepResult {
    double gap = 0.0;      ///< relative to the distance between the quartiles
    char coordinate = ' '; ///< `x`, `y`, `z`, or `u`, `v` of the unit square
    double spacing = 0.0;  ///< expected gap of as many values that are spread evenly
    double rounding = 0.0; ///< gap that rounding to single precision explains
    double emptied = 0.0;  ///< part of the middle half that is gaps: 1 for points on lines

    /// Of 65536 continuous outputs none has a gap of a 500th of the middle half, unless the density
    /// there is far below its mean: 65536 exp(-65) < 1e-23.
    [[nodiscard]] bool isStepped() const {
        return gap > kTolerableStep + rounding && gap > 50.0 * spacing;
    }

    /// A hole is one gap; lines leave nothing but gaps.
    [[nodiscard]] bool isLined() const { return isStepped() && emptied > 0.9; }

    static constexpr double kTolerableStep = 0.002;
};

/// Looks for outputs that lie on lines, because a random number was rounded: histograms whose cells
/// match the lines, or cross them, cannot see it. Judged are the middle halves of x, y, z and of
/// the unit square's coordinates. \param outputs  those within the domain count
StepResult judgeSteps(const catalog::WarpEntry &entry, double a, std::span<const Output> outputs);

} // namespace battery
