// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>

#include <viewer/vertices.h>
#include <window/color_map.h>

namespace viewer {

namespace {

/// More strata than this are no longer seen as lines.
constexpr int kMaxStrata = 64;
/// Where the colours of points end: what follows is not seen on white paper.
constexpr double kBrightest = 0.65;
constexpr double kErrorRange = 0.01; ///< relative density error at the end of the colours

using Line = std::vector<window::Vertex>;

void addSegment(Line &lines, const battery::Output &a, const battery::Output &b,
                std::uint32_t color) {
    lines.push_back({a.x, a.y, a.z, color});
    lines.push_back({b.x, b.y, b.z, color});
}

void addPolyline(Line &lines, std::span<const battery::Output> points, std::uint32_t color) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        addSegment(lines, points[i], points[i + 1], color);
    }
}

void addUnitFrame(Line &lines, std::uint32_t color) {
    const battery::Output corners[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}};
    addPolyline(lines, corners, color);
}

/// The scale of a colouring: each value divided by its largest (or a fixed) one.
std::vector<double> colorValues(const Cloud &cloud, ColorBy by) {
    std::vector<double> values(cloud.outputs.size(), 0.5);
    if (by == ColorBy::Order) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = static_cast<double>(i) / static_cast<double>(values.size());
        }
    } else if (by == ColorBy::Density && !cloud.densities.empty()) {
        double largest = 0.0;
        for (const float density : cloud.densities) {
            largest =
                std::isfinite(density) ? std::max(largest, static_cast<double>(density)) : largest;
        }
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = static_cast<double>(cloud.densities[i]) / (largest > 0.0 ? largest : 1.0);
        }
    } else if (by == ColorBy::Error && !cloud.densities.empty()) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] =
                densityError(static_cast<double>(cloud.densities[i]), cloud.exact[i]) / kErrorRange;
        }
    }
    return values;
}

} // namespace

std::vector<std::uint32_t> pointColors(ViewModel &model, const LineColors &colors) {
    const std::vector<bool> selection = model.selection();
    const Cloud &cloud = model.cloud();
    const std::vector<double> values = colorValues(cloud, model.settings().colorBy);
    std::vector<std::uint32_t> result(cloud.inputs.size(), colors.muted);
    for (std::size_t i = 0; i < result.size(); ++i) {
        if (selection.empty() || selection[i]) {
            result[i] = i < values.size() ? window::viridis(kBrightest * values[i]) : colors.grid;
        }
    }
    return result;
}

std::vector<window::Vertex> spacePoints(ViewModel &model, const LineColors &colors) {
    const std::vector<std::uint32_t> shades = pointColors(model, colors);
    const Cloud &cloud = model.cloud();
    std::vector<window::Vertex> points;
    points.reserve(cloud.outputs.size());
    for (std::size_t i = 0; i < cloud.outputs.size(); ++i) {
        const battery::Output &p = cloud.outputs[i];
        points.push_back({p.x, p.y, p.z, shades[i]});
    }
    return points;
}

std::vector<window::Vertex> spaceLines(ViewModel &model, const LineColors &colors) {
    const Cloud &cloud = model.cloud();
    Line lines;
    constexpr float kAxis = 1.2F;
    addSegment(lines, {0, 0, 0}, {kAxis, 0, 0}, colors.axis);
    addSegment(lines, {0, 0, 0}, {0, kAxis, 0}, colors.axis);
    if (model.subject().truth->dimension == 3) {
        addSegment(lines, {0, 0, 0}, {0, 0, kAxis}, colors.axis);
        constexpr int kSteps = 96;
        for (int i = 0; i < kSteps; ++i) {
            const auto at = [](int step) {
                const double angle = 2.0 * std::numbers::pi * step / kSteps;
                return battery::Output{static_cast<float>(std::cos(angle)),
                                       static_cast<float>(std::sin(angle)), 0.0F};
            };
            addSegment(lines, at(i), at(i + 1), colors.boundary);
        }
    }
    addPolyline(lines, cloud.boundary, colors.boundary);
    constexpr std::size_t kPoints = kGridSteps + 1;
    for (std::size_t at = 0; at + kPoints <= cloud.gridLines.size(); at += kPoints) {
        addPolyline(lines, std::span(cloud.gridLines).subspan(at, kPoints), colors.grid);
    }
    return lines;
}

std::vector<window::Vertex> flatPoints(ViewModel &model, Brush::View view,
                                       const battery::DomainMap &domain, const LineColors &colors) {
    const std::vector<std::uint32_t> shades = pointColors(model, colors);
    const Cloud &cloud = model.cloud();
    std::vector<window::Vertex> points;
    if (view == Brush::View::Square) {
        for (std::size_t i = 0; i < cloud.inputs.size(); ++i) {
            points.push_back({cloud.inputs[i].u, cloud.inputs[i].v, 0.0F, shades[i]});
        }
        return points;
    }
    for (std::size_t i = 0; i < cloud.outputs.size(); ++i) {
        const std::array<double, 2> at = domain.place(battery::toPoint(cloud.outputs[i]));
        points.push_back({static_cast<float>(at[0]), static_cast<float>(at[1]), 0.0F, shades[i]});
    }
    return points;
}

std::vector<window::Vertex> flatLines(ViewModel &model, Brush::View view,
                                      const battery::DomainMap &domain, const LineColors &colors) {
    const Cloud &cloud = model.cloud();
    Line lines;
    addUnitFrame(lines, colors.axis);
    const auto side = static_cast<int>(std::sqrt(static_cast<double>(cloud.inputs.size())));
    if (view == Brush::View::Square && model.settings().points == PointSet::Stratified &&
        side <= kMaxStrata) {
        for (int i = 1; i < side; ++i) {
            const float at = static_cast<float>(i) / static_cast<float>(side);
            addSegment(lines, {at, 0, 0}, {at, 1, 0}, colors.grid);
            addSegment(lines, {0, at, 0}, {1, at, 0}, colors.grid);
        }
    }
    if (view == Brush::View::Domain && !domain.directions) {
        std::vector<battery::Output> boundary;
        for (const battery::Output &p : cloud.boundary) {
            const std::array<double, 2> at = domain.place(battery::toPoint(p));
            boundary.push_back({static_cast<float>(at[0]), static_cast<float>(at[1]), 0.0F});
        }
        addPolyline(lines, boundary, colors.boundary);
    }
    return lines;
}

} // namespace viewer
