// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

#include <cmath>
#include <vector>

#include "fixtures.h"

/// Irradiances of simple lights that are known exactly, on a surface at the origin with normal +z.
/// Radiances are 1, lengths and angles [rad] in double precision.
namespace nori::test::closed_form {

/// The part of a polygon with z >= 0.
inline std::vector<Eigen::Vector3d> clipToHorizon(const std::vector<Eigen::Vector3d> &polygon) {
    std::vector<Eigen::Vector3d> clipped;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const Eigen::Vector3d &a = polygon[i];
        const Eigen::Vector3d &b = polygon[(i + 1) % polygon.size()];
        if (a.z() >= 0.0)
            clipped.push_back(a);
        if ((a.z() >= 0.0) != (b.z() >= 0.0))
            clipped.emplace_back(a + (b - a) * (a.z() / (a.z() - b.z())));
    }
    return clipped;
}

/// Of a polygon, counterclockwise as seen from the origin.
/// \see Lambert, "Photometria", 1760; half the sum of edge angles times the cosines of their planes
inline double polygon(const std::vector<Eigen::Vector3d> &vertices) {
    const std::vector<Eigen::Vector3d> clipped = clipToHorizon(vertices);
    double sum = 0.0;
    for (size_t i = 0; i < clipped.size(); ++i) {
        const Eigen::Vector3d &a = clipped[i];
        const Eigen::Vector3d &b = clipped[(i + 1) % clipped.size()];
        const Eigen::Vector3d normal = b.cross(a);
        if (normal.norm() > 0.0)
            sum += std::atan2(normal.norm(), a.dot(b)) * normal.z() / normal.norm();
    }
    return 0.5 * sum;
}

/// Of a sphere wholly above the horizon.
inline double sphere(const Eigen::Vector3d &center, double radius) {
    return kPi * radius * radius * center.z() / std::pow(center.norm(), 3);
}

/// Of a disk at height `h` that faces the origin, with its centre on the normal.
inline double disk(double h, double radius) {
    return kPi * radius * radius / (radius * radius + h * h);
}

/// Variance of the estimator of disk() that draws one point uniformly from the disk's area.
inline double diskVariance(double h, double radius) {
    const double r2 = radius * radius;
    const double secondMoment =
        kPi * r2 * (kPi * std::pow(h, 4) / 3.0) * (std::pow(h, -6) - std::pow(h * h + r2, -3));
    return secondMoment - disk(h, radius) * disk(h, radius);
}

/// Of a rectangle of sides `a` and `b` at height `h` that faces down, one corner on the normal.
inline double rectangle(double a, double b, double h) {
    const double p = std::hypot(a, h);
    const double q = std::hypot(b, h);
    return 0.5 * (a / p * std::atan(b / p) + b / q * std::atan(a / q));
}

/// Of the whole sky of radiance 1 + slope . direction, which must not be negative.
inline double linearSky(const Eigen::Vector3d &slope) {
    return kPi + 2.0 * kPi / 3.0 * slope.z();
}

/// Of a constant sky behind a black disk around the zenith that hides a cone of this half angle.
inline double skyBehindDisk(double angle) {
    return kPi * std::cos(angle) * std::cos(angle);
}

} // namespace nori::test::closed_form
