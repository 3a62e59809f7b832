// SPDX-License-Identifier: MIT
#pragma once

#include <catalog/warp_entry.h>

#include <span>
#include <string_view>

namespace catalog {

/// A known way to get a density wrong that is more than a constant factor (see density_ratio.h for
/// those), written as the wrong density itself, on the enlarged domain.
struct DensityMistake {
    std::string_view warpId;
    std::string_view id;
    std::string_view description; ///< one sentence for the student, in English
    double (*density)(const Point &p, double a);
};

/// All known mistakes, grouped by warp.
std::span<const DensityMistake> densityMistakes();

} // namespace catalog
