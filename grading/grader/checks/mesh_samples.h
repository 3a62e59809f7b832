// SPDX-License-Identifier: MIT
#pragma once

#include <grader/checks/check.h>
#include <grader/scenes/test_scene.h>

#include <optional>
#include <utility>
#include <vector>

namespace grader {

/// A sampled point and where on the mesh it is.
struct MeshSample {
    Vector3d position;
    Vector3d normal;
    Vector2d uv;
    std::size_t face = 0; ///< the nearest one
    Vector3d weights;     ///< barycentric, of the face's vertices
    double distance = 0;  ///< from the face, relative to the mesh's size; NaN when not finite

    /// Where a uniform point of the triangle is uniform: the square-root map's inverse.
    std::pair<double, double> unitSquare() const;
};

struct MeshAnswer {
    std::vector<MeshSample> samples;
    std::optional<CheckResult> failure; ///< set when there is nothing to judge
};

/// Asks Mesh::samplePosition for `count` independent points.
MeshAnswer askMeshSamples(CheckContext &context, const TestScene &scene, int index,
                          const TestMesh &mesh, int count, std::uint64_t seed);

/// Finds the nearest face and the barycentric weights of `sample.position`.
void locate(const TestMesh &mesh, MeshSample &sample);

/// Unit normal at the sample's place: interpolated vertex normals, else the face's.
Vector3d expectedNormal(const TestMesh &mesh, const MeshSample &sample);

/// Interpolated texture coordinates at the sample's place.
Vector2d expectedUv(const TestMesh &mesh, const MeshSample &sample);

} // namespace grader
