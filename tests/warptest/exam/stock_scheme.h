// SPDX-License-Identifier: MIT
#pragma once

#include "configurations.h"

namespace warp_exam {

struct StockVerdict {
    bool accepted = false;
    double pValue = 0.0; ///< 0 also where the scheme gives up before it has one
};

/// The chi^2 test that Nori's own `warptest` makes, rebuilt as a measuring stick: 51 rows (102x51
/// cells for directions, and for the triangle, which its list of planar warps lacks), 1000 samples
/// per cell from pcg32 as it starts, outputs clamped into the grid, expectations by nested adaptive
/// Simpson with an absolute tolerance of 1e-6, cells below 5 pooled into one, level 0.01.
StockVerdict stockScheme(const Configuration &configuration);

} // namespace warp_exam
