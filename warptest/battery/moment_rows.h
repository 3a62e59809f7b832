// SPDX-License-Identifier: MIT
#pragma once

#include <battery/records.h>

#include <span>
#include <string>
#include <vector>

namespace battery {

/// A moment of the points beside that of the density.
struct MomentRow {
    std::string name; ///< "mean of x²"
    double found = 0.0;
    double standardError = 0.0; ///< of `found`
    double expected = 0.0;

    /// Deviation in standard errors; N(0, 1) for a right warp. 0 where nothing varies.
    [[nodiscard]] double z() const;
};

/// First and second moments of the coordinates. For people: the verdict rests on smooth moments of
/// stratified points, which see a thousand times less.
/// \param outputs  of independent inputs; those that are not finite are left out
std::vector<MomentRow> momentRows(const catalog::WarpEntry &truth, double a,
                                  std::span<const Output> outputs);

} // namespace battery
