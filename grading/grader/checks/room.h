// SPDX-License-Identifier: MIT
#pragma once

#include <grader/checks/radiance_case.h>
#include <grader/scenes/test_mesh.h>
#include <grader/scenes/test_scene.h>

#include <cstdint>

namespace grader {

/// A floor to be lit. Generic numbers everywhere: equal lights, unit areas and distances, grey
/// surfaces and frames along the axes hide mistakes (statistics.md §5, 18).
struct Room {
    static constexpr int kColumns = 16; ///< rays per row

    explicit Room(std::uint64_t seed);

    /// A parallelogram light above the floor that shines down on it.
    TestMesh lightMesh(const Vector3d &center, double width, double depth) const;

    /// Of a point of the room, whose floor is z = 0; as a float holds it.
    Vector3d world(const Vector3d &local) const;

    /// Rays onto the floor from 0.35 in front of it, shape [kColumns, kColumns], drawn from
    /// `random`; what is expected along them is left open.
    RadianceCase onFloor();

    SceneRandom random;
    Eigen::Isometry3d pose; ///< from the room to the world
    Vector3d albedo;        ///< of the floor
    TestMesh floor;         ///< in the world
    TestScene scene;        ///< with the floor
};

} // namespace grader
