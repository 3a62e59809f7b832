// SPDX-License-Identifier: MIT
#pragma once

#include <battery/records.h>

#include <span>

namespace battery {

/// From here on neighbours are as far apart as any two points, and their inputs are but seeds: a
/// warp that is continuous but for some lines has a few times 1 / side.
inline constexpr double kScattered = 0.5;

/// Median distance between the outputs of neighbouring inputs, relative to that between outputs of
/// inputs half a square apart.
///
/// \param outputs  of stratifiedInputs(side, ...), in their order
double neighbourDistance(std::span<const Output> outputs, int side);

} // namespace battery
