// SPDX-License-Identifier: MIT
#include "points.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

namespace grader {

Hundredths toHundredths(double points) {
    return std::llround(points * 100);
}

std::string formatPoints(double points) {
    const Hundredths hundredths = toHundredths(points);
    const Hundredths size = std::abs(hundredths);
    const char *sign = hundredths < 0 ? "-" : "";
    if (size % 100 == 0)
        return fmt::format("{}{}", sign, size / 100);
    if (size % 10 == 0)
        return fmt::format("{}{}.{}", sign, size / 100, size / 10 % 10);
    return fmt::format("{}{}.{:02}", sign, size / 100, size % 100);
}

} // namespace grader
