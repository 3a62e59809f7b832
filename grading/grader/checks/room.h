// SPDX-License-Identifier: MIT
#pragma once

#include <grader/checks/radiance_case.h>
#include <grader/scenes/test_mesh.h>
#include <grader/scenes/test_scene.h>

namespace grader {

/// A floor to be lit. Generic numbers everywhere: equal lights, unit areas and distances, grey
/// surfaces and frames along the axes hide mistakes (statistics.md §5, 18).
struct Room {
    static constexpr int kColumns = 16; ///< of rays onto a parallelogram, and rows

    explicit Room(std::uint64_t seed);

    /// A parallelogram light above the floor that shines down on it.
    TestMesh lightMesh(const Vector3d &center, double width, double depth) const;

    /// Of a point of the room, whose floor is z = 0; as a float holds it.
    Vector3d world(const Vector3d &local) const;

    /// Rays onto the floor; what is expected along them is left open.
    RadianceCase onFloor();

    SceneRandom random;
    Eigen::Isometry3d pose;
    Vector3d albedo;
    TestMesh floor;
    TestScene scene;
};

} // namespace grader
