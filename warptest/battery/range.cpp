// SPDX-License-Identifier: MIT
#include "range.h"

#include <battery/inputs.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace battery {

RangeResult judgeRange(const catalog::WarpEntry &entry, std::span<const Input> inputs,
                       std::span<const Output> outputs) {
    if (inputs.size() != outputs.size()) {
        throw std::invalid_argument("judgeRange: one output per input is needed");
    }
    RangeResult result;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const catalog::Point p = toPoint(outputs[i]);
        const catalog::Placement placement = catalog::placement(entry, p);
        const bool good = placement == catalog::Placement::Inside;
        if (!isWithinContract(inputs[i])) {
            result.badBeyondContract += good ? 0 : 1;
            continue;
        }
        ++result.total;
        if (good) {
            continue;
        }
        if (result.bad() == 0) {
            result.firstBad = i;
        }
        switch (placement) {
        case catalog::Placement::NotFinite:
            ++result.notFinite;
            break;
        case catalog::Placement::OffNorm:
            ++result.offNorm;
            result.worstDistance =
                std::max(result.worstDistance, std::fabs(std::hypot(p.x, p.y, p.z) - 1.0));
            break;
        case catalog::Placement::Outside:
        case catalog::Placement::Inside:
            ++result.outside;
            result.worstDistance = std::max(result.worstDistance, -entry.margin(p));
            break;
        }
    }
    return result;
}

} // namespace battery
