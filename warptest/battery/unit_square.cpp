// SPDX-License-Identifier: MIT
#include "unit_square.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace battery {

UnitSquarePoints toUnitSquare(const catalog::WarpEntry &entry, double a,
                              std::span<const Output> outputs) {
    const bool round = entry.dimension == 3 || entry.id == "disk";
    UnitSquarePoints points;
    points.total = outputs.size();
    points.u.reserve(outputs.size());
    points.v.reserve(outputs.size());
    for (const Output &output : outputs) {
        const catalog::Point p = toPoint(output);
        if (catalog::placement(entry, p) != catalog::Placement::Inside) {
            continue;
        }
        catalog::Square s = entry.rosenblatt(p, a);
        if (round && p.x == 0.0 && p.y == 0.0) {
            // The azimuth of the pole is undefined. Collapsed poles are a loss of precision, not of
            // uniformity, so they must not pile up in one cell: golden ratio steps spread them.
            s.v = static_cast<double>(points.poleAtoms) * (std::numbers::phi - 1.0);
            s.v -= std::floor(s.v);
            ++points.poleAtoms;
        }
        points.u.push_back(std::clamp(s.u, 0.0, 1.0));
        points.v.push_back(std::clamp(s.v, 0.0, 1.0));
    }
    return points;
}

std::vector<double> countCells(const UnitSquarePoints &points, int uBins, int vBins) {
    std::vector<double> counts(static_cast<std::size_t>(uBins) * static_cast<std::size_t>(vBins));
    for (std::size_t i = 0; i < points.u.size(); ++i) {
        const int row = std::min(uBins - 1, static_cast<int>(points.u[i] * uBins));
        const int column = std::min(vBins - 1, static_cast<int>(points.v[i] * vBins));
        counts[static_cast<std::size_t>(row) * static_cast<std::size_t>(vBins) +
               static_cast<std::size_t>(column)] += 1.0;
    }
    return counts;
}

} // namespace battery
