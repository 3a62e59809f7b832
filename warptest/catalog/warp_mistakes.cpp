// SPDX-License-Identifier: MIT
#include "warp_mistakes.h"

#include <catalog/round_chart.h>

#include <array>

namespace catalog {

namespace {

/// Direction with polar angle `theta` and azimuth in turns.
Point atAngle(double theta, double turns) {
    return polar(std::sin(theta), turns, std::cos(theta));
}

double beckmannTangent2(double u, double a) {
    return -a * a * std::log1p(-u);
}

constexpr auto
    kMistakes =
        std::
            to_array<WarpMistake>(
                {
                    // Triangle
                    {"triangle", "missing_sqrt",
                     "The square root is missing: the first coordinate is spread evenly, so points "
                     "crowd at one "
                     "corner.",
                     [](const Square &s, double) {
                         return Point{1.0 - s.u, s.v * s.u, 0.0};
                     }},
                    {"triangle", "unfolded_square",
                     "The whole unit square is filled: points with x + y > 1 are not folded back.",
                     [](const Square &s, double) {
                         return Point{s.u, s.v, 0.0};
                     }},
                    {"triangle", "clamped",
                     "Points beyond the hypotenuse are clamped onto it instead of being folded "
                     "back.",
                     [](const Square &s, double) {
                         return Point{s.u, std::min(s.v, 1.0 - s.u), 0.0};
                     }},
                    {"triangle", "one_component",
                     "Only one of the two random numbers is used: the points lie on a curve.",
                     [](const Square &s, double) {
                         return Point{1.0 - std::sqrt(s.u), s.u * std::sqrt(s.u), 0.0};
                     }},
                    {"triangle", "divided_by_sum",
                     "The two random numbers are divided by their sum: the points lie on the "
                     "hypotenuse.",
                     [](const Square &s, double) {
                         return Point{s.u / (s.u + s.v), s.v / (s.u + s.v), 0.0};
                     }},
                    {"triangle", "three_uniforms",
                     "Three random numbers are divided by their sum: points crowd at the centroid.",
                     [](const Square &s, double) {
                         const double third = 256.0 * s.u - std::floor(256.0 * s.u);
                         const double sum = s.u + s.v + third;
                         return Point{s.u / sum, s.v / sum};
                     }},
                    {"triangle", "three_weights",
                     "Two random numbers and the fraction of their sum are divided by their sum: "
                     "points crowd around the centroid.",
                     [](const Square &s, double) {
                         const double third = std::fmod(s.u + s.v, 1.0);
                         const double sum = s.u + s.v + third;
                         return Point{s.u / sum, s.v / sum};
                     }},
                    {"triangle", "half_fold",
                     "Points with x + y > 1 are halved instead of being mirrored.",
                     [](const Square &s, double) {
                         const double scale = s.u + s.v > 1.0 ? 0.5 : 1.0;
                         return Point{scale * s.u, scale * s.v, 0.0};
                     }},
                    {"triangle", "squared",
                     "The random number is squared where its square root is needed.",
                     [](const Square &s, double) {
                         const double rest = s.u * s.u;
                         return Point{1.0 - rest, s.v * rest, 0.0};
                     }},
                    {"triangle", "scaled_after_sqrt",
                     "The second coordinate is not multiplied by the square root, so points leave "
                     "the triangle.",
                     [](const Square &s, double) {
                         return Point{1.0 - std::sqrt(s.u), s.v, 0.0};
                     }},
                    // Disk
                    {"disk", "missing_sqrt",
                     "The square root of the radius is missing: points crowd at the centre.",
                     [](const Square &s, double) {
                         return polar(s.u, s.v, 0.0);
                     }},
                    {"disk", "squared",
                     "The radius is squared where the square root is needed: points crowd at the "
                     "centre.",
                     [](const Square &s, double) {
                         return polar(s.u * s.u, s.v, 0.0);
                     }},
                    {"disk", "half_turn", "The angle covers half a turn only (pi instead of 2 pi).",
                     [](const Square &s, double) {
                         return polar(std::sqrt(s.u), 0.5 * s.v, 0.0);
                     }},
                    {"disk", "square", "The square [-1, 1]^2 is filled instead of the disk.",
                     [](const Square &s, double) {
                         return Point{2.0 * s.u - 1.0, 2.0 * s.v - 1.0, 0.0};
                     }},
                    {"disk", "one_component",
                     "Only one of the two random numbers is used: the points lie on a spiral.",
                     [](const Square &s, double) {
                         return polar(std::sqrt(s.u), s.u, 0.0);
                     }},
                    {"disk", "half_radius", "The disk has radius 1/2 instead of 1.",
                     [](const Square &s, double) {
                         return polar(0.5 * std::sqrt(s.u), s.v, 0.0);
                     }},
                    // Sphere
                    {"sphere", "uniform_theta",
                     "The polar angle is spread evenly (theta = pi u), so directions crowd at the "
                     "poles.",
                     [](const Square &s, double) {
                         return atAngle(kPi * s.u, s.v);
                     }},
                    {"sphere", "half_turn",
                     "The azimuth covers half a turn only (pi instead of 2 pi).",
                     [](const Square &s, double) {
                         return direction(2.0 * s.u - 1.0, 0.5 * s.v);
                     }},
                    {"sphere", "hemisphere", "Only one half of the sphere is covered.",
                     [](const Square &s, double) {
                         return direction(s.u, s.v);
                     }},
                    {"sphere", "not_scaled",
                     "x and y are not multiplied by the sine of the polar angle: the points lie on "
                     "a cylinder.",
                     [](const Square &s, double) {
                         return polar(1.0, s.v, 2.0 * s.u - 1.0);
                     }},
                    {"sphere", "one_component",
                     "Only one of the two random numbers is used: the directions lie on a curve.",
                     [](const Square &s, double) {
                         return direction(2.0 * s.u - 1.0, s.u);
                     }},
                    {"sphere", "cosine",
                     "The sphere is cosine-weighted: directions crowd around the z axis.",
                     [](const Square &s, double) {
                         const double w = 2.0 * s.u - 1.0;
                         return direction(std::copysign(std::sqrt(std::fabs(w)), w), s.v);
                     }},
                    // Hemisphere
                    {"hemisphere", "cosine_weighted",
                     "The directions are cosine-weighted, but uniform ones are asked for.",
                     [](const Square &s, double) {
                         return direction(std::sqrt(1.0 - s.u), s.v);
                     }},
                    {"hemisphere", "uniform_theta",
                     "The polar angle is spread evenly (theta = pi/2 u), so directions crowd at "
                     "the pole.",
                     [](const Square &s, double) {
                         return atAngle(0.5 * kPi * s.u, s.v);
                     }},
                    {"hemisphere",
                     "whole_sphere", "The whole sphere is covered: half of the directions lie below the horizon.",
                     [](const Square &s, double) {
                         return direction(2.0 * s.u - 1.0, s.v);
                     }},
                    {"hemisphere", "lower_half", "The hemisphere points to -z instead of +z.",
                     [](const Square &s, double) {
                         return direction(-s.u, s.v);
                     }},
                    {"hemisphere",
                     "around_y", "The hemisphere is built around the y axis instead of z.",
                     [](const Square &s, double) {
                         const Point p = direction(s.u, s.v);
                         return Point{p.x, p.z, p.y};
                     }},
                    {"hemisphere", "half_turn",
                     "The azimuth covers half a turn only (pi instead of 2 pi).",
                     [](const Square &s, double) {
                         return direction(s.u, 0.5 * s.v);
                     }},
                    {"hemisphere", "one_component",
                     "Only one of the two random numbers is used: the directions lie on a curve.",
                     [](const Square &s, double) {
                         return direction(s.u, s.u);
                     }},
                    {"hemisphere", "lifted_uniform_disk_radius",
                     "A disk without the square root is lifted onto the hemisphere: directions "
                     "crowd at the pole.",
                     [](const Square &s, double) {
                         return direction(std::sqrt(1.0 - s.u * s.u), s.v);
                     }},
                    // Cosine hemisphere
                    {"cosine_hemisphere", "uniform",
                     "The directions are uniform on the hemisphere, but cosine-weighted ones are "
                     "asked for.",
                     [](const Square &s, double) {
                         return direction(s.u, s.v);
                     }},
                    {"cosine_hemisphere", "uniform_theta",
                     "The polar angle is spread evenly (theta = pi/2 u).",
                     [](const Square &s, double) {
                         return atAngle(0.5 * kPi * s.u, s.v);
                     }},
                    {"cosine_hemisphere",
                     "missing_sqrt", "The disk that is lifted onto the hemisphere lacks its square root (r = u).",
                     [](const Square &s, double) {
                         return direction(std::sqrt(1.0 - s.u * s.u), s.v);
                     }},
                    {"cosine_hemisphere", "squared_cosine",
                     "The directions have the density cos^2: a root of the wrong order is taken.",
                     [](const Square &s, double) {
                         return direction(std::cbrt(s.u), s.v);
                     }},
                    {"cosine_hemisphere",
                     "around_y", "The hemisphere is built around the y axis instead of z.",
                     [](const Square &s, double) {
                         const Point p = direction(std::sqrt(1.0 - s.u), s.v);
                         return Point{p.x, p.z, p.y};
                     }},
                    {"cosine_hemisphere", "not_lifted",
                     "The disk is not lifted onto the hemisphere: z does not make the direction "
                     "unit length.",
                     [](const Square &s, double) {
                         return polar(std::sqrt(s.u), s.v, 0.0);
                     }},
                    {"cosine_hemisphere", "both_sides",
                     "Both hemispheres are covered: half of the directions lie below the horizon.",
                     [](const Square &s, double) {
                         const double w = 2.0 * s.u - 1.0;
                         return direction(std::copysign(std::sqrt(std::fabs(w)), w), s.v);
                     }},
                    {"cosine_hemisphere", "half_turn",
                     "The azimuth covers half a turn only (pi instead of 2 pi).",
                     [](const Square &s, double) {
                         return direction(std::sqrt(1.0 - s.u), 0.5 * s.v);
                     }},
                    {"cosine_hemisphere", "one_component",
                     "Only one of the two random numbers is used: the directions lie on a curve.",
                     [](const Square &s, double) {
                         return direction(std::sqrt(1.0 - s.u), s.u);
                     }},
                    // Beckmann
                    {"beckmann", "ggx",
                     "GGX is sampled (tan^2 = a^2 u / (1 - u)) instead of Beckmann.",
                     [](const Square &s, double a) {
                         return directionOfTangent(a * a * s.u / std::max(1e-15, 1.0 - s.u), s.v);
                     }},
                    {"beckmann", "alpha_not_squared",
                     "alpha is not squared: tan^2 = -alpha log(1 - u).",
                     [](const Square &s, double a) {
                         return directionOfTangent(-a * std::log1p(-s.u), s.v);
                     }},
                    {"beckmann", "twice_alpha_squared",
                     "The exponent is divided by 2 alpha^2 (a Gaussian's variance): the lobe is "
                     "too wide.",
                     [](const Square &s, double a) {
                         return directionOfTangent(2.0 * beckmannTangent2(s.u, a), s.v);
                     }},
                    {"beckmann", "half_alpha_squared",
                     "tan^2 is half of what it should be: the lobe is too narrow.",
                     [](const Square &s, double a) {
                         return directionOfTangent(0.5 * beckmannTangent2(s.u, a), s.v);
                     }},
                    {"beckmann", "alpha_to_the_fourth",
                     "alpha is squared twice: the lobe is too narrow.",
                     [](const Square &s, double a) {
                         return directionOfTangent(a * a * beckmannTangent2(s.u, a), s.v);
                     }},
                    {"beckmann", "alpha_ignored_1",
                     "alpha is ignored: the lobe is that of alpha = 1.",
                     [](const Square &s, double) {
                         return directionOfTangent(beckmannTangent2(s.u, 1.0), s.v);
                     }},
                    {"beckmann", "alpha_ignored_0_1",
                     "alpha is ignored: the lobe is that of alpha = 0.1.",
                     [](const Square &s, double) {
                         return directionOfTangent(beckmannTangent2(s.u, 0.1), s.v);
                     }},
                    {"beckmann", "decimal_logarithm", "The logarithm is to base 10 instead of e.",
                     [](const Square &s, double a) {
                         return directionOfTangent(beckmannTangent2(s.u, a) / std::numbers::ln10,
                                                   s.v);
                     }},
                    {"beckmann", "missing_root", "tan^2 is used as tan: a square root is missing.",
                     [](const Square &s, double a) {
                         const double t = beckmannTangent2(s.u, a);
                         return directionOfTangent(t * t, s.v);
                     }},
                    {"beckmann", "missing_arctangent",
                     "The tangent is used as the angle itself: the arc tangent is missing.",
                     [](const Square &s, double a) {
                         return atAngle(std::sqrt(beckmannTangent2(s.u, a)), s.v);
                     }},
                    {"beckmann", "cosine_hemisphere",
                     "A cosine-weighted hemisphere is sampled instead.",
                     [](const Square &s, double) {
                         return direction(std::sqrt(1.0 - s.u), s.v);
                     }},
                    {"beckmann", "half_turn",
                     "The azimuth covers half a turn only (pi instead of 2 pi).",
                     [](const Square &s, double a) {
                         return directionOfTangent(beckmannTangent2(s.u, a), 0.5 * s.v);
                     }},
                    {"beckmann", "one_component",
                     "Only one of the two random numbers is used: the directions lie on a curve.",
                     [](const Square &s, double a) {
                         return directionOfTangent(beckmannTangent2(s.u, a), s.u);
                     }},
                });

} // namespace

std::span<const WarpMistake> warpMistakes() {
    return kMistakes;
}

} // namespace catalog
