// SPDX-License-Identifier: MIT
#include "chart.h"

#include <catalog/round_chart.h>

namespace catalog {

Chart rectangle(const Point &low, const Point &high) {
    const double width = high.x - low.x;
    const double height = high.y - low.y;
    return {.dimension = 2,
            .point =
                [=](const Square &s) {
                    return Point{low.x + s.u * width, low.y + s.v * height, 0.0};
                },
            .place =
                [=](const Point &p) {
                    return Square{(p.x - low.x) / width, (p.y - low.y) / height};
                },
            .stretch =
                [=](const Square &) {
                    return width * height;
                }};
}

Chart zone(double lowest, double highest) {
    const double height = highest - lowest;
    return {.dimension = 3,
            .point = [=](const Square &s) { return direction(lowest + s.u * height, s.v); },
            .place =
                [=](const Point &p) {
                    return Square{(p.z - lowest) / height, turn(p.x, p.y)};
                },
            .stretch =
                [=](const Square &) {
                    return 2.0 * kPi * height;
                }};
}

Chart latitudeLongitude(int rows, int columns) {
    return {.dimension = 3,
            .point =
                [](const Square &s) {
                    const double angle = kPi * s.u;
                    const Point p = polar(std::sin(angle), s.v, 0.0);
                    return Point{p.x, std::cos(angle), p.y};
                },
            .place =
                [](const Point &p) {
                    return Square{std::atan2(std::hypot(p.x, p.z), p.y) / kPi, turn(p.x, p.z)};
                },
            .stretch = [](const Square &s) { return 2.0 * kPi * kPi * std::sin(kPi * s.u); },
            .uCells = rows,
            .vCells = columns};
}

Chart lobe(double width) {
    const double square = width * width;
    return {.dimension = 3,
            .point =
                [=](const Square &s) {
                    return directionOfTangent(square * s.u / std::max(1e-300, 1.0 - s.u), s.v);
                },
            .place =
                [=](const Point &p) {
                    const double sine2 = p.x * p.x + p.y * p.y;
                    const double u = sine2 / (sine2 + square * p.z * p.z);
                    return Square{p.z < 0.0 ? 2.0 : u, turn(p.x, p.y)};
                },
            .stretch =
                [=](const Square &s) {
                    const double rest = std::max(1e-300, 1.0 - s.u);
                    const double tangent2 = square * s.u / rest;
                    return kPi * square / (rest * rest * std::pow(1.0 + tangent2, 1.5));
                }};
}

} // namespace catalog
