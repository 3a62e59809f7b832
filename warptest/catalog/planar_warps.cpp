// SPDX-License-Identifier: MIT
#include "planar_warps.h"

#include <catalog/round_chart.h>

#include <array>

namespace catalog::planar {

namespace {

double wellConditioned(const Point & /*p*/, double /*a*/) {
    return 1.0;
}

Point onSegment(const Point &a, const Point &b, double t) {
    return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), 0.0};
}

template <std::size_t Corners>
Point onPolygon(const std::array<Point, Corners> &corners, double t) {
    const double scaled = t * static_cast<double>(Corners);
    const auto side = std::min(static_cast<std::size_t>(scaled), Corners - 1);
    return onSegment(corners[side], corners[(side + 1) % Corners],
                     scaled - static_cast<double>(side));
}

/// Distribution function of the tent on [-1, 1], and its inverse.
double tentCdf(double t) {
    return t < 0.0 ? 0.5 * (1.0 + t) * (1.0 + t) : 1.0 - 0.5 * (1.0 - t) * (1.0 - t);
}

double tentQuantile(double p) {
    return p < 0.5 ? std::sqrt(2.0 * p) - 1.0 : 1.0 - std::sqrt(2.0 * (1.0 - p));
}

} // namespace

WarpEntry square() {
    return {
        .id = "square",
        .rubricId = "",
        .warpFunction = "Warp::squareToUniformSquare",
        .densityFunction = "Warp::squareToUniformSquarePdf",
        .dimension = 2,
        .hasParameter = false,
        .parameters = {0.0},
        .formula = [](const Point & /*p*/, double /*a*/) { return 1.0; },
        .warp =
            [](const Square &s, double /*a*/) {
                return Point{s.u, s.v, 0.0};
            },
        .rosenblatt =
            [](const Point &p, double /*a*/) {
                return Square{p.x, p.y};
            },
        .conditioning = wellConditioned,
        .margin =
            [](const Point &p) {
                return std::min({p.x, p.y, 1.0 - p.x, 1.0 - p.y});
            },
        .enlarged =
            [](const Square &s) {
                return Point{2.0 * s.u - 0.5, 2.0 * s.v - 0.5, 0.0};
            },
        .enlargedMeasure = 4.0,
        .boundary =
            [](double t) {
                return onPolygon<4>({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}}, t);
            },
    };
}

WarpEntry tent() {
    return {
        .id = "tent",
        .rubricId = "",
        .warpFunction = "Warp::squareToTent",
        .densityFunction = "Warp::squareToTentPdf",
        .dimension = 2,
        .hasParameter = false,
        .parameters = {0.0},
        .formula = [](const Point &p,
                      double /*a*/) { return (1.0 - std::fabs(p.x)) * (1.0 - std::fabs(p.y)); },
        .warp =
            [](const Square &s, double /*a*/) {
                return Point{tentQuantile(s.u), tentQuantile(s.v), 0.0};
            },
        .rosenblatt =
            [](const Point &p, double /*a*/) {
                return Square{tentCdf(p.x), tentCdf(p.y)};
            },
        .conditioning =
            [](const Point &p, double /*a*/) {
                return 1.0 / std::max(1e-9, 1.0 - std::fabs(p.x)) +
                       1.0 / std::max(1e-9, 1.0 - std::fabs(p.y));
            },
        .margin =
            [](const Point &p) { return std::min(1.0 - std::fabs(p.x), 1.0 - std::fabs(p.y)); },
        .enlarged =
            [](const Square &s) {
                return Point{3.0 * s.u - 1.5, 3.0 * s.v - 1.5, 0.0};
            },
        .enlargedMeasure = 9.0,
        .boundary =
            [](double t) {
                return onPolygon<4>({{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}}, t);
            },
    };
}

WarpEntry disk() {
    return {
        .id = "disk",
        .rubricId = "warp.disk",
        .warpFunction = "Warp::squareToUniformDisk",
        .densityFunction = "Warp::squareToUniformDiskPdf",
        .dimension = 2,
        .hasParameter = false,
        .parameters = {0.0},
        .formula = [](const Point & /*p*/, double /*a*/) { return 1.0 / kPi; },
        .warp = [](const Square &s, double /*a*/) { return polar(std::sqrt(s.u), s.v, 0.0); },
        .rosenblatt =
            [](const Point &p, double /*a*/) {
                return Square{p.x * p.x + p.y * p.y, turn(p.x, p.y)};
            },
        .conditioning = wellConditioned,
        .margin = [](const Point &p) { return 1.0 - std::sqrt(p.x * p.x + p.y * p.y); },
        .enlarged =
            [](const Square &s) {
                return Point{3.0 * s.u - 1.5, 3.0 * s.v - 1.5, 0.0};
            },
        .enlargedMeasure = 9.0,
        .boundary = [](double t) { return polar(1.0, t, 0.0); },
    };
}

WarpEntry triangle() {
    return {
        .id = "triangle",
        .rubricId = "warp.triangle",
        .warpFunction = "Warp::squareToUniformTriangle",
        .densityFunction = "Warp::squareToUniformTrianglePdf",
        .dimension = 2,
        .hasParameter = false,
        .parameters = {0.0},
        .formula = [](const Point & /*p*/, double /*a*/) { return 2.0; },
        .warp =
            [](const Square &s, double /*a*/) {
                const double rest = std::sqrt(1.0 - s.u);
                return Point{1.0 - rest, s.v * rest, 0.0};
            },
        .rosenblatt =
            [](const Point &p, double /*a*/) {
                const double rest = 1.0 - p.x;
                return Square{1.0 - rest * rest, rest > 0.0 ? p.y / rest : 0.0};
            },
        .conditioning = wellConditioned,
        .margin =
            [](const Point &p) {
                return std::min({p.x, p.y, (1.0 - p.x - p.y) / std::numbers::sqrt2});
            },
        .enlarged =
            [](const Square &s) {
                return Point{2.0 * s.u - 0.5, 2.0 * s.v - 0.5, 0.0};
            },
        .enlargedMeasure = 4.0,
        .boundary =
            [](double t) {
                return onPolygon<3>({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, t);
            },
    };
}

} // namespace catalog::planar
