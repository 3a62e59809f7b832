// SPDX-License-Identifier: MIT
#pragma once

#include <battery/records.h>
#include <catalog/warp_mistakes.h>

#include <span>
#include <vector>

namespace battery {

struct MistakeMatch {
    const catalog::WarpMistake *mistake = nullptr; ///< null: no known mistake explains the outputs
    double explained = 0.0; ///< part of the distance from the right distribution that is explained
};

/// All known mistakes of the warp, best first, each in the orientation that fits best.
/// \throws std::invalid_argument  if there are no outputs
std::vector<MistakeMatch> rankMistakes(const catalog::WarpEntry &entry, double a,
                                       std::span<const Output> outputs);

/// The known mistake whose predicted histogram comes closest to the outputs, in any orientation of
/// the domain; none unless it explains 95 % of their distance from the right distribution. A guess
/// for the report, never a verdict.
MistakeMatch nearestMistake(const catalog::WarpEntry &entry, double a,
                            std::span<const Output> outputs);

} // namespace battery
