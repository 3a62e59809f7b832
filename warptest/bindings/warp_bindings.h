// SPDX-License-Identifier: MIT
#pragma once

#include <battery/records.h>

#include <span>
#include <string_view>
#include <vector>

namespace bindings {

/// Calls the warp of <nori/warp.h> with this id of the catalogue, once for each input.
/// \param a  its parameter; ignored by warps without one
/// \throws std::invalid_argument  if there is no such warp; and what the warp throws
std::vector<battery::Output> callWarp(std::string_view id, std::span<const battery::Input> inputs,
                                      double a);

/// The density that comes with it, at these points.
std::vector<float> callDensity(std::string_view id, std::span<const battery::Output> points,
                               double a);

} // namespace bindings
