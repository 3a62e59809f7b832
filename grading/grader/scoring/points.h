// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace grader {

/// Points are added in hundredths, so that sums are exact and do not depend on their order.
using Hundredths = std::int64_t;

/// Nearest hundredth.
Hundredths toHundredths(double points);

inline double toPoints(Hundredths hundredths) {
    return static_cast<double>(hundredths) / 100;
}

/// `10`, `7.5`, `7.25`: at most two decimals, none that say nothing.
std::string formatPoints(double points);

} // namespace grader
