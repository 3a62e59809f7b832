// SPDX-License-Identifier: MIT
#include "scatter.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace battery {

namespace {

/// Over all finite distances from an output to the one `step` places on.
double medianDistance(std::span<const Output> outputs, std::size_t step) {
    std::vector<double> distances;
    distances.reserve(outputs.size());
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const catalog::Point a = toPoint(outputs[i]);
        const catalog::Point b = toPoint(outputs[(i + step) % outputs.size()]);
        const double distance = std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
        if (std::isfinite(distance))
            distances.push_back(distance);
    }
    if (distances.empty())
        return 0;
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    return *middle;
}

} // namespace

double neighbourDistance(std::span<const Output> outputs, int side) {
    const auto wide = static_cast<std::size_t>(side);
    if (side < 2 || outputs.size() != wide * wide)
        throw std::invalid_argument("neighbourDistance: needs side * side outputs");
    const double apart = medianDistance(outputs, outputs.size() / 2 + wide / 2);
    return apart > 0 ? medianDistance(outputs, 1) / apart : 0;
}

} // namespace battery
