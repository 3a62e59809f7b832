// SPDX-License-Identifier: MIT
#pragma once

#include <grader/checks/check.h>
#include <grader/checks/radiance_diagnosis.h>
#include <grader/scenes/test_scene.h>

#include <vector>

namespace grader {

/// A diffuse place that is lit.
struct LitPoint {
    Vector3d position;
    Vector3d normal;
    Vector3d albedo;
};

/// What wrong integrators make of one parallelogram light, by midpoints on it.
std::vector<Hypothesis> areaLightMistakes(const std::vector<LitPoint> &points,
                                          const TestMesh &light, const Vector3d &radiance);

// Experiments after a failure: small scenes whose answer is lit or dark, each made for one mistake.

/// Puts a blocker at several parts of the way from a surface to a point light, and behind it.
std::vector<Guess> experimentWithShadows(CheckContext &context);

/// Looks at a light from its front and from behind, with the world's origin on either side.
std::vector<Guess> experimentWithSides(CheckContext &context);

} // namespace grader
