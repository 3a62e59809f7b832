// SPDX-License-Identifier: MIT
#include "directional_warps.h"

#include <catalog/round_chart.h>

#include <array>

namespace catalog::directional {

namespace {

/// 1 hides an alpha that is not squared, 0.01 hides a missing cosine: all are needed.
constexpr std::initializer_list<double> kBeckmannAlphas{0.01, 0.03, 0.1, 0.3, 1.0};

double wellConditioned(const Point & /*p*/, double /*a*/) {
    return 1.0;
}

double height(const Point &p) {
    return p.z;
}

Point anyDirection(const Square &s) {
    return direction(2.0 * s.u - 1.0, s.v);
}

Point equator(double t) {
    return polar(1.0, t, 0.0);
}

double tangent2(const Point &p) {
    return (p.x * p.x + p.y * p.y) / (p.z * p.z);
}

} // namespace

WarpEntry sphere() {
    return {
        .id = "sphere",
        .rubricId = "warp.sphere",
        .warpFunction = "Warp::squareToUniformSphere",
        .densityFunction = "Warp::squareToUniformSpherePdf",
        .dimension = 3,
        .hasParameter = false,
        .parameters = {0.0},
        .formula = [](const Point & /*p*/, double /*a*/) { return 1.0 / (4.0 * kPi); },
        .warp = [](const Square &s, double /*a*/) { return direction(2.0 * s.u - 1.0, s.v); },
        .rosenblatt =
            [](const Point &p, double /*a*/) {
                return Square{0.5 * (1.0 + p.z), turn(p.x, p.y)};
            },
        .conditioning = wellConditioned,
        .margin = [](const Point & /*p*/) { return 1.0; },
        .enlarged = anyDirection,
        .enlargedMeasure = 4.0 * kPi,
    };
}

WarpEntry hemisphere() {
    return {
        .id = "hemisphere",
        .rubricId = "warp.hemisphere",
        .warpFunction = "Warp::squareToUniformHemisphere",
        .densityFunction = "Warp::squareToUniformHemispherePdf",
        .dimension = 3,
        .hasParameter = false,
        .parameters = {0.0},
        .formula = [](const Point & /*p*/, double /*a*/) { return 1.0 / (2.0 * kPi); },
        .warp = [](const Square &s, double /*a*/) { return direction(s.u, s.v); },
        .rosenblatt =
            [](const Point &p, double /*a*/) {
                return Square{p.z, turn(p.x, p.y)};
            },
        .conditioning = wellConditioned,
        .margin = height,
        .enlarged = anyDirection,
        .enlargedMeasure = 4.0 * kPi,
        .boundary = equator,
    };
}

WarpEntry cosineHemisphere() {
    return {
        .id = "cosine_hemisphere",
        .rubricId = "warp.cosine_hemisphere",
        .warpFunction = "Warp::squareToCosineHemisphere",
        .densityFunction = "Warp::squareToCosineHemispherePdf",
        .dimension = 3,
        .hasParameter = false,
        .parameters = {0.0},
        .formula = [](const Point &p, double /*a*/) { return p.z / kPi; },
        .warp = [](const Square &s,
                   double /*a*/) { return polar(std::sqrt(s.u), s.v, std::sqrt(1.0 - s.u)); },
        .rosenblatt =
            [](const Point &p, double /*a*/) {
                return Square{p.x * p.x + p.y * p.y, turn(p.x, p.y)};
            },
        // The cosine may also be recovered from x and y.
        .conditioning = [](const Point &p,
                           double /*a*/) { return 1.0 + 1.0 / std::max(1e-12, p.z * p.z); },
        .margin = height,
        .enlarged = anyDirection,
        .enlargedMeasure = 4.0 * kPi,
        .boundary = equator,
    };
}

WarpEntry beckmann() {
    return {
        .id = "beckmann",
        .rubricId = "warp.beckmann",
        .warpFunction = "Warp::squareToBeckmann",
        .densityFunction = "Warp::squareToBeckmannPdf",
        .dimension = 3,
        .hasParameter = true,
        .parameters = kBeckmannAlphas,
        .formula =
            [](const Point &p, double a) {
                if (p.z == 0.0) {
                    return 0.0; // the limit: the exponential beats the power of 1/z
                }
                return std::exp(-tangent2(p) / (a * a)) / (kPi * a * a * p.z * p.z * p.z);
            },
        .warp = [](const Square &s,
                   double a) { return directionOfTangent(-a * a * std::log1p(-s.u), s.v); },
        // From x and y: 1 - z^2 would cancel at small a.
        .rosenblatt =
            [](const Point &p, double a) {
                const double u = p.z == 0.0 ? 1.0 : -std::expm1(-tangent2(p) / (a * a));
                return Square{u, turn(p.x, p.y)};
            },
        .conditioning = [](const Point &p,
                           double a) { return 2.0 / std::max(1e-30, a * a * p.z * p.z) + 3.0; },
        .margin = height,
        .enlarged = anyDirection,
        .enlargedMeasure = 4.0 * kPi,
        .boundary = equator,
        .edgeConditioning = [](double a) { return 2.0 / (a * a); },
    };
}

} // namespace catalog::directional
