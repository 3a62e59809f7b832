// SPDX-License-Identifier: MIT
#include <battery/domain_map.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace battery {

std::array<double, 2> DomainMap::place(const catalog::Point &p) const {
    const std::array<double, 2> at =
        directions ? std::array{std::atan2(p.y, p.x), p.z} : std::array{p.x, p.y};
    return {(at[0] - low[0]) / (high[0] - low[0]), (at[1] - low[1]) / (high[1] - low[1])};
}

catalog::Point DomainMap::point(const std::array<double, 2> &place) const {
    const double x = low[0] + place[0] * (high[0] - low[0]);
    const double y = low[1] + place[1] * (high[1] - low[1]);
    if (!directions) {
        return {x, y, 0.0};
    }
    const double sine = std::sqrt(std::max(0.0, 1.0 - y * y));
    return {sine * std::cos(x), sine * std::sin(x), y};
}

double DomainMap::measure() const {
    return (high[0] - low[0]) * (high[1] - low[1]);
}

DomainMap makeDomainMap(const catalog::WarpEntry &truth) {
    DomainMap domain;
    domain.directions = truth.dimension == 3;
    domain.xLabel = domain.directions ? "φ" : "x";
    domain.yLabel = domain.directions ? "cos θ" : "y";
    // The supports end at whole numbers: a few outputs of the right warp tell which.
    constexpr int kProbes = 33;
    std::array<double, 3> low{0.0, 0.0, 0.0};
    std::array<double, 3> high{0.0, 0.0, 0.0};
    for (int i = 0; i < kProbes * kProbes; ++i) {
        const int row = i / kProbes;
        const int column = i % kProbes;
        const catalog::Square s{column / (kProbes - 1.0), row / (kProbes - 1.0)};
        const catalog::Point p = truth.warp(s, truth.parameters.front());
        const std::array<double, 3> at{p.x, p.y, p.z};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], std::round(at[axis]));
            high[axis] = std::max(high[axis], std::round(at[axis]));
        }
    }
    if (domain.directions) {
        domain.low = {-std::numbers::pi, low[2]};
        domain.high = {std::numbers::pi, high[2]};
    } else {
        domain.low = {low[0], low[1]};
        domain.high = {high[0], high[1]};
    }
    return domain;
}

} // namespace battery
