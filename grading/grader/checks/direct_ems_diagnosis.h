// SPDX-License-Identifier: MIT
#pragma once

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

/// What wrong choices of one of several lights make of them: with probability p_i, what is sent is
/// not divided by p_i, multiplied by it, or divided twice, and light i counts p_i, p_i^2 or 1 / p_i
/// times, where p goes with the luminance of the power or its mean; or one light alone counts, once
/// or 1 / p_i times, or one is left out.
/// \param lights       what each sends along each ray, shape [lights, rays]
/// \param intensities  of the lights
std::vector<Hypothesis> choiceMistakes(const std::vector<std::vector<Vector3d>> &lights,
                                       const std::vector<Vector3d> &intensities);

} // namespace grader
