// SPDX-License-Identifier: MIT
#pragma once

#include <catalog/warp_entry.h>

namespace battery {

/// What a warp is called with.
struct Input {
    float u = 0.0F;
    float v = 0.0F;
};

/// What a warp returned, or where a density is asked; z is 0 in the plane.
struct Output {
    float x = 0.0F;
    float y = 0.0F;
    float z = 0.0F;
};

inline catalog::Point toPoint(const Output &output) {
    return {static_cast<double>(output.x), static_cast<double>(output.y),
            static_cast<double>(output.z)};
}

inline Output toOutput(const catalog::Point &point) {
    return {static_cast<float>(point.x), static_cast<float>(point.y), static_cast<float>(point.z)};
}

} // namespace battery
