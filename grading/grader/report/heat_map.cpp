// SPDX-License-Identifier: MIT
#include "heat_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include <window/color_map.h>

namespace grader {

namespace {

constexpr double kResidualRange = 4.0; ///< standard deviations at the ends of the colours
constexpr int kLevels = 64;            ///< colours of a map: cells of one are one path
constexpr int kBarSteps = 16;

std::string hex(std::uint32_t color) {
    return fmt::format("#{:02x}{:02x}{:02x}", color & 255U, color >> 8U & 255U,
                       color >> 16U & 255U);
}

/// A value in [0, 1] as the middle of one of kLevels.
double quantised(double t) {
    const double level = std::floor(std::clamp(t, 0.0, 1.0) * kLevels);
    return (std::min(level, kLevels - 1.0) + 0.5) / kLevels;
}

std::string sizeColor(double t) {
    return hex(window::viridis(quantised(t)));
}

std::string residualColor(double z) {
    return hex(window::diverging(2.0 * quantised((z / kResidualRange + 1.0) / 2.0) - 1.0));
}

/// Cells as squares of one unit, those of one colour as one path.
std::string cells(int side, const std::function<std::string(std::size_t)> &colorOf) {
    std::map<std::string, std::string> paths;
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            const int cell = row * side + column;
            // row 0 is at the bottom
            paths[colorOf(static_cast<std::size_t>(cell))] +=
                fmt::format("M{} {}h1v1h-1z", column, side - 1 - row);
        }
    }
    std::string svg;
    for (const auto &[color, path] : paths) {
        svg += fmt::format(R"(<path fill="{0}" stroke="{0}" d="{1}"/>)", color, path);
    }
    return svg;
}

std::string figure(const battery::Maps &maps, const std::string &name, const std::string &label,
                   const std::function<std::string(std::size_t)> &colorOf) {
    const battery::DomainMap &domain = maps.domain;
    return fmt::format(
        "<figure class=\"map\"><figcaption><strong>{}</strong></figcaption>\n"
        "<svg role=\"img\" aria-label=\"{}\" viewBox=\"0 0 {} {}\" stroke-width=\".15\" "
        "preserveAspectRatio=\"none\">{}</svg>\n"
        "<p>{} {:.3g} … {:.3g} →<br>{} {:.3g} … {:.3g} ↑</p></figure>\n",
        name, label, maps.side, maps.side, cells(maps.side, colorOf), domain.xLabel, domain.low[0],
        domain.high[0], domain.yLabel, domain.low[1], domain.high[1]);
}

/// A bar of all colours with its ends in words.
std::string colorBar(const std::string &low, const std::string &high,
                     const std::function<std::string(double)> &colorOf) {
    std::string steps;
    for (int i = 0; i < kBarSteps; ++i) {
        steps += fmt::format(R"(<rect x="{}" width="1" height="1" fill="{}"/>)", i,
                             colorOf((i + 0.5) / kBarSteps));
    }
    return fmt::format(
        "<p class=\"bar\">{} <svg aria-hidden=\"true\" viewBox=\"0 0 {} 1\" "
        "shape-rendering=\"crispEdges\" preserveAspectRatio=\"none\">{}</svg> {}</p>\n",
        low, kBarSteps, steps, high);
}

/// The cells that are farthest off, at most kWorstCells.
std::string worstCells(const battery::Maps &maps) {
    constexpr std::size_t kWorstCells = 5;
    std::vector<std::size_t> order(maps.residual.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const std::size_t count = std::min(kWorstCells, order.size());
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count),
                      order.end(), [&](std::size_t a, std::size_t b) {
                          return std::fabs(maps.residual[a]) > std::fabs(maps.residual[b]);
                      });
    std::string html = "<details><summary>The five cells that are farthest off</summary>\n"
                       "<div class=\"scroll\"><table>\n<thead><tr><th scope=\"col\">Cell</th>"
                       "<th scope=\"col\" class=\"number\">Observed</th>"
                       "<th scope=\"col\" class=\"number\">Expected</th>"
                       "<th scope=\"col\" class=\"number\">σ</th></tr></thead>\n<tbody>\n";
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t cell = order[i];
        html += fmt::format("<tr><th scope=\"row\">{}</th><td class=\"number\">{:.0f}</td>"
                            "<td class=\"number\">{:.1f}</td><td class=\"number\">{:+.1f}</td>"
                            "</tr>\n",
                            placeOf(maps, cell), maps.observed[cell], maps.expected[cell],
                            maps.residual[cell]);
    }
    return html + "</tbody>\n</table></div></details>\n";
}

} // namespace

std::string placeOf(const battery::Maps &maps, std::size_t cell) {
    const auto side = static_cast<std::size_t>(maps.side);
    const std::array<std::size_t, 2> index{cell % side, cell / side};
    std::array<double, 2> at{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const double low = maps.domain.low.at(axis);
        at.at(axis) = low + (maps.domain.high.at(axis) - low) *
                                (static_cast<double>(index.at(axis)) + 0.5) / maps.side;
    }
    return fmt::format("{} {:.3f}, {} {:.3f}", maps.domain.xLabel, at[0], maps.domain.yLabel,
                       at[1]);
}

std::string mapFigures(const battery::Maps &maps) {
    const double scale = std::max(maps.largest, 1.0);
    const std::size_t worst = battery::worstCell(maps);
    std::string html = "<div class=\"maps\">\n";
    html += figure(maps, "Observed", "Map of the observed counts",
                   [&](std::size_t i) { return sizeColor(maps.observed[i] / scale); });
    html += figure(maps, "Expected", "Map of the expected counts",
                   [&](std::size_t i) { return sizeColor(maps.expected[i] / scale); });
    html += figure(maps, "Residual (O−E)/√E",
                   fmt::format("Map of the residuals; the largest is {:+.1f} standard deviations "
                               "at {}",
                               maps.residual[worst], placeOf(maps, worst)),
                   [&](std::size_t i) {
                       return maps.sparse[i] ? "#808080" : residualColor(maps.residual[i]);
                   });
    html += "</div>\n";
    html += colorBar("0", fmt::format("{:.0f} points in a cell", maps.largest), sizeColor);
    html += colorBar("−4 σ: too few", "+4 σ: too many",
                     [](double t) { return residualColor(kResidualRange * (2.0 * t - 1.0)); });
    html += fmt::format(
        "<p>{} independent points in {}×{} cells, {} outside of the map; grey: fewer than {:.0f} "
        "expected. The largest residual is {:+.1f} σ at {}: {:.0f} observed, {:.1f} "
        "expected.</p>\n",
        maps.points, maps.side, maps.side, maps.outside, battery::kMinExpected,
        maps.residual[worst], placeOf(maps, worst), maps.observed[worst], maps.expected[worst]);
    return html + worstCells(maps);
}

} // namespace grader
