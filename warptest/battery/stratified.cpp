// SPDX-License-Identifier: MIT
#include "stratified.h"

#include <battery/unit_square.h>
#include <statistics/stratified_moments.h>

#include <cmath>
#include <stdexcept>

namespace battery {

StratifiedResult judgeStratified(const catalog::WarpEntry &entry, double a,
                                 std::span<const Output> outputs) {
    const int side = static_cast<int>(std::lround(std::sqrt(static_cast<double>(outputs.size()))));
    if (outputs.empty() ||
        static_cast<std::size_t>(side) * static_cast<std::size_t>(side) != outputs.size()) {
        throw std::invalid_argument("judgeStratified: needs side * side outputs");
    }
    const UnitSquarePoints points = toUnitSquare(entry, a, outputs);
    StratifiedResult result;
    result.total = points.total;
    result.invalid = points.invalid();
    result.threshold = catalog::stratifiedTolerance(entry, a, side);
    if (points.u.empty()) {
        result.maxMoment = 2.0; // the largest a moment can be
        return result;
    }
    const statistics::StratifiedMoments moments = statistics::stratifiedMoments(points.u, points.v);
    result.moments.assign(moments.values.begin(), moments.values.end());
    result.momentIndex = moments.indexOfMax();
    result.maxMoment = moments.maxAbs();
    return result;
}

statistics::StageResult asStage(const StratifiedResult &result) {
    return {.pValue = result.exceeds() ? 0.0 : 1.0,
            .effect = result.maxMoment,
            .effectBound = result.maxMoment,
            .mde = result.threshold,
            .deviation = result.moments};
}

} // namespace battery
