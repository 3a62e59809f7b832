// SPDX-License-Identifier: MIT
#include "density_mistakes.h"

#include <catalog/round_chart.h>

#include <array>

namespace catalog {

namespace {

double zero(const Point & /*p*/, double /*a*/) {
    return 0.0;
}

double tangent2(const Point &p) {
    return (p.x * p.x + p.y * p.y) / (p.z * p.z);
}

/// Beckmann's D cos of a slope distribution with exponent tan^2 / `spread`, above the horizon.
double beckmannLobe(const Point &p, double spread) {
    return p.z > 0.0 ? std::exp(-tangent2(p) / spread) / (kPi * spread * p.z * p.z * p.z) : 0.0;
}

bool inTriangle(const Point &p) {
    return p.x >= 0.0 && p.y >= 0.0 && p.x + p.y <= 1.0;
}

constexpr std::string_view kZeroText = "The density is 0 everywhere: is it implemented?";

constexpr auto kMistakes =
    std::to_array<DensityMistake>({
        {"triangle", "zero", kZeroText, zero},
        {"triangle", "no_lower_bounds",
         "The density is also positive for x < 0 or y < 0: the lower bounds are not checked.",
         [](const Point &p, double) {
             return p.x + p.y <= 1.0 ? 2.0 : 0.0;
         }},
        {"triangle", "everywhere", "The density does not become 0 outside of the triangle.",
         [](const Point &, double) {
             return 2.0;
         }},
        {"triangle", "one_everywhere",
         "The density is 1 everywhere: it should be 1/area = 2, and 0 outside of the triangle.",
         [](const Point &, double) {
             return 1.0;
         }},
        {"triangle", "unit_square", "The density is that of the unit square.",
         [](const Point &p, double) {
             return p.x >= 0.0 && p.y >= 0.0 && p.x <= 1.0 && p.y <= 1.0 ? 1.0 : 0.0;
         }},
        {"triangle", "square_support",
         "The density is positive on the whole unit square: x + y <= 1 is not checked.",
         [](const Point &p, double) {
             return p.x >= 0.0 && p.y >= 0.0 && p.x <= 1.0 && p.y <= 1.0 ? 2.0 : 0.0;
         }},
        {"triangle", "complement", "The density is positive outside of the triangle and 0 inside.",
         [](const Point &p, double) {
             return inTriangle(p) ? 0.0 : 2.0;
         }},
        {"disk", "zero", kZeroText, zero},
        {"disk", "everywhere", "The density does not become 0 outside of the disk.",
         [](const Point &, double) {
             return 1.0 / kPi;
         }},
        {"disk", "one_everywhere",
         "The density is 1 everywhere: it should be 1/pi, and 0 outside of the disk.",
         [](const Point &, double) {
             return 1.0;
         }},
        {"disk", "square_support",
         "The density is positive on the whole square [-1, 1]^2 around the disk.",
         [](const Point &p, double) {
             return std::fabs(p.x) <= 1.0 && std::fabs(p.y) <= 1.0 ? 1.0 / kPi : 0.0;
         }},
        {"disk", "quarter", "The density is 0 for x < 0 or y < 0.",
         [](const Point &p, double) {
             return p.x >= 0.0 && p.y >= 0.0 && std::hypot(p.x, p.y) <= 1.0 ? 1.0 / kPi : 0.0;
         }},
        {"sphere", "zero", kZeroText, zero},
        {"sphere", "upper_half_only",
         "The density is 0 below the horizon, but the sphere is asked for.",
         [](const Point &p, double) {
             return p.z >= 0.0 ? 1.0 / (4.0 * kPi) : 0.0;
         }},
        {"hemisphere", "zero", kZeroText, zero},
        {"hemisphere", "below_horizon",
         "The density is positive below the horizon too: z >= 0 is not checked.",
         [](const Point &, double) {
             return 1.0 / (2.0 * kPi);
         }},
        {"hemisphere", "sphere", "The density is that of the whole sphere, 1/(4 pi).",
         [](const Point &, double) {
             return 1.0 / (4.0 * kPi);
         }},
        {"hemisphere", "cosine",
         "The density is the cosine-weighted one, but uniform is asked for.",
         [](const Point &p, double) {
             return std::max(0.0, p.z) / kPi;
         }},
        {"cosine_hemisphere", "zero", kZeroText, zero},
        {"cosine_hemisphere", "absolute_cosine",
         "The density is |z|/pi: positive below the horizon too.",
         [](const Point &p, double) {
             return std::fabs(p.z) / kPi;
         }},
        {"cosine_hemisphere", "negative_below", "The density is negative below the horizon.",
         [](const Point &p, double) {
             return p.z / kPi;
         }},
        {"cosine_hemisphere", "around_y", "The density tests z, but returns y/pi.",
         [](const Point &p, double) {
             return p.z > 0.0 ? p.y / kPi : 0.0;
         }},
        {"cosine_hemisphere", "uniform", "The density is the uniform one, without the cosine.",
         [](const Point &p, double) {
             return p.z > 0.0 ? 1.0 / (2.0 * kPi) : 0.0;
         }},
        {"cosine_hemisphere", "sphere", "The density is that of the whole sphere, 1/(4 pi).",
         [](const Point &, double) {
             return 1.0 / (4.0 * kPi);
         }},
        {"beckmann", "zero", kZeroText, zero},
        {"beckmann", "missing_cosine", "The density is D(m): the cosine is missing.",
         [](const Point &p, double a) {
             return p.z > 0.0 ? beckmannLobe(p, a * a) / p.z : 0.0;
         }},
        {"beckmann", "ggx", "The density is that of GGX instead of Beckmann.",
         [](const Point &p, double a) {
             if (p.z <= 0.0) {
                 return 0.0;
             }
             const double s = a * a + tangent2(p);
             return a * a / (kPi * p.z * p.z * p.z * s * s);
         }},
        {"beckmann", "alpha_not_squared", "alpha is not squared.",
         [](const Point &p, double a) {
             return beckmannLobe(p, a);
         }},
        {"beckmann", "alpha_not_squared_in_exponent", "alpha is not squared in the exponent.",
         [](const Point &p, double a) {
             return beckmannLobe(p, a) / a;
         }},
        {"beckmann", "twice_alpha_squared",
         "The exponent is divided by 2 alpha^2 (a Gaussian's variance).",
         [](const Point &p, double a) {
             return beckmannLobe(p, 2.0 * a * a);
         }},
        {"beckmann", "tangent_not_squared", "The exponent holds tan instead of tan^2.",
         [](const Point &p, double a) {
             return p.z > 0.0 ? std::exp(-std::sqrt(tangent2(p)) / (a * a)) /
                                    (kPi * a * a * p.z * p.z * p.z)
                              : 0.0;
         }},
        {"beckmann", "below_horizon", "The density is not 0 below the horizon.",
         [](const Point &p, double a) {
             return beckmannLobe({p.x, p.y, std::fabs(p.z)}, a * a);
         }},
        {"beckmann", "negative_below", "The density is negative below the horizon.",
         [](const Point &p, double a) {
             return std::copysign(beckmannLobe({p.x, p.y, std::fabs(p.z)}, a * a), p.z);
         }},
    });

} // namespace

std::span<const DensityMistake> densityMistakes() {
    return kMistakes;
}

} // namespace catalog
