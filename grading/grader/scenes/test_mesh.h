// SPDX-License-Identifier: MIT
#pragma once

#include <statistics/random.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace grader {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Draws what scenes are made of.
class SceneRandom : public statistics::Random {
public:
    using Random::Random;

    double uniform(double low = 0, double high = 1);
    Vector3d direction(); ///< uniform on the unit sphere
    Vector3d color(double low, double high);
    Eigen::Isometry3d rigid(double reach); ///< uniform rotation; translation in [-reach, reach]^3
};

/// A triangle mesh as the grader knows it, in world space and in double precision.
struct TestMesh {
    std::vector<Vector3d> positions;
    std::vector<Vector3d> normals; ///< per vertex, or empty
    std::vector<Vector2d> uvs;     ///< per vertex, or empty
    std::vector<std::array<int, 3>> faces;

    double area() const;
    double area(std::size_t face) const;
    Vector3d geometricNormal(std::size_t face) const; ///< unit, by the winding

    /// The mesh moved, normals too, and rounded to floats: what the renderer reads is then exactly
    /// what we compute with.
    TestMesh transformed(const Eigen::Isometry3d &transform) const;

    /// As Wavefront OBJ that reads back as the same floats.
    std::string toObj() const;
};

/// `corner`, `corner + a`, `corner + a + b`, `corner + b`: two equal triangles with normal a x b
/// and texture coordinates, without vertex normals.
TestMesh parallelogram(const Vector3d &corner, const Vector3d &a, const Vector3d &b);

/// The same, cut into `pieces` x `pieces` parallelograms of unequal widths.
TestMesh patch(const Vector3d &corner, const Vector3d &a, const Vector3d &b, int pieces,
               SceneRandom &random);

/// A box with its normals outside, turned by `turn` [radians] about the z axis through its center.
TestMesh block(const Vector3d &center, const Vector3d &size, double turn);

/// `stacks` x 2 `stacks` patches with vertex normals and texture coordinates, triangles at the
/// poles.
TestMesh sphere(const Vector3d &center, double radius, int stacks);

/// A bent strip of triangles whose areas differ by a factor of more than 20, without normals and
/// texture coordinates.
TestMesh unequalStrip(SceneRandom &random);

/// Irradiance at `point` with unit normal `normal` from a polygon of constant radiance 1,
/// unoccluded, whichever way round its vertices are given. The polygon is clipped to the horizon.
/// \see Lambert's formula, as in Baum et al. 1989 eq. 9
double polygonIrradiance(const Vector3d &point, const Vector3d &normal,
                         const std::vector<Vector3d> &polygon);

} // namespace grader
