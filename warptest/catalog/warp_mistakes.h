// SPDX-License-Identifier: MIT
#pragma once

#include <catalog/warp_entry.h>

#include <span>
#include <string_view>

namespace catalog {

/// A known way to get a warp wrong, written as the wrong warp itself: what it does to uniform
/// points predicts the histogram of any implementation that makes this mistake.
struct WarpMistake {
    std::string_view warpId;
    std::string_view id;
    std::string_view description; ///< one sentence for the student, in English
    Point (*warp)(const Square &s, double a);
};

/// All known mistakes, grouped by warp.
std::span<const WarpMistake> warpMistakes();

} // namespace catalog
