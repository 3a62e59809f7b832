// SPDX-License-Identifier: MIT
#pragma once

#include <catalog/warp_entry.h>

#include <algorithm>
#include <cmath>
#include <numbers>

/// Polar coordinates that the round warps share.
namespace catalog {

inline constexpr double kPi = std::numbers::pi;

/// Azimuth of (x, y) in turns, in [0, 1).
inline double turn(double x, double y) {
    const double t = std::atan2(y, x) / (2.0 * kPi);
    return t < 0.0 ? t + 1.0 : t;
}

/// Point at radius r and azimuth `turns`, height z.
inline Point polar(double r, double turns, double z) {
    const double angle = 2.0 * kPi * turns;
    return {r * std::cos(angle), r * std::sin(angle), z};
}

/// Unit direction with the given z and azimuth.
inline Point direction(double z, double turns) {
    return polar(std::sqrt(std::max(0.0, 1.0 - z * z)), turns, z);
}

/// Unit direction with the given tangent of the polar angle, squared, and azimuth.
inline Point directionOfTangent(double tangent2, double turns) {
    const double z = 1.0 / std::sqrt(1.0 + tangent2);
    return polar(std::sqrt(tangent2) * z, turns, z);
}

} // namespace catalog
