// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace window {

/// A colour as ImGui and Texture have it: 0xAABBGGRR.
std::uint32_t packColor(double red, double green, double blue, double alpha = 1.0);

/// Viridis, for sizes: dark blue at 0 to yellow at 1; clamped.
std::uint32_t viridis(double t);

/// Blue at -1, white at 0, orange at 1, for signed deviations; clamped.
std::uint32_t diverging(double t);

/// What stands for "not a number" in every map.
inline constexpr std::uint32_t kNotANumberColor = 0xffff00ff;

} // namespace window
