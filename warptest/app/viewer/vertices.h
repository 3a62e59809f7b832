// SPDX-License-Identifier: MIT
#pragma once

#include <battery/domain_map.h>

#include <cstdint>
#include <vector>

#include <viewer/view_model.h>
#include <window/point_view.h>

namespace viewer {

/// Colours of what is beside the points.
struct LineColors {
    std::uint32_t axis = 0;
    std::uint32_t grid = 0;
    std::uint32_t boundary = 0;
    std::uint32_t muted = 0; ///< points out of the brush
};

/// One colour for each output, by the settings; points out of the brush are muted.
std::vector<std::uint32_t> pointColors(ViewModel &model, const LineColors &colors);

/// The outputs, where they are.
std::vector<window::Vertex> spacePoints(ViewModel &model, const LineColors &colors);
/// Axes, boundary of the support, warped grid; a circle of latitude and the equator for directions.
std::vector<window::Vertex> spaceLines(ViewModel &model, const LineColors &colors);

/// The inputs in the unit square, or the outputs in the domain map: z = 0.
std::vector<window::Vertex> flatPoints(ViewModel &model, Brush::View view,
                                       const battery::DomainMap &domain, const LineColors &colors);
/// Frame and strata of the square, or frame of the domain map and boundary of the domain.
std::vector<window::Vertex> flatLines(ViewModel &model, Brush::View view,
                                      const battery::DomainMap &domain, const LineColors &colors);

} // namespace viewer
