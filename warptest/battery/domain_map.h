// SPDX-License-Identifier: MIT
#pragma once

#include <battery/records.h>
#include <catalog/warp_entry.h>

#include <array>
#include <string>

namespace battery {

/// A flat picture of a warp's domain, of which equal areas are equal areas (solid angles) of the
/// domain: x and y in the plane; phi and cos(theta) for directions.
struct DomainMap {
    std::array<double, 2> low{}; ///< of the two coordinates
    std::array<double, 2> high{};
    bool directions = false;
    std::string xLabel;
    std::string yLabel;

    /// \return  place in [0, 1]^2; anything else for points outside of the map
    [[nodiscard]] std::array<double, 2> place(const catalog::Point &p) const;
    /// The point at a place of [0, 1]^2.
    [[nodiscard]] catalog::Point point(const std::array<double, 2> &place) const;
    /// Area of the whole map, in the measure of the density.
    [[nodiscard]] double measure() const;
};

/// Covers the support of the warp.
DomainMap makeDomainMap(const catalog::WarpEntry &truth);

} // namespace battery
