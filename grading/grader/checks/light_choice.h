// SPDX-License-Identifier: MIT
#pragma once

#include <grader/checks/radiance_case.h>

#include <optional>
#include <string>
#include <vector>

namespace grader {

/// How often an integrator chooses each of several point lights, read off the colours of its
/// samples: every light has a chromaticity of its own, so one sample of one light names it. Works
/// for whatever method of the Scene the integrator calls.
struct LightChoice {
    RadianceCase test;        ///< the scene, its rays and its closed form
    Vector3d albedo{1, 1, 1}; ///< of what the lights shine on
    std::vector<Vector3d> intensities;
    std::vector<double> frequencies; ///< per light, of the recognised samples
    double recognised = 0;           ///< part of the samples that come from one light
    std::optional<CheckResult> failure;

    bool isUniform() const;
};

LightChoice measureChoice(CheckContext &context);

/// The weight that the frequencies follow best.
struct ChoiceLaw {
    std::string name;      ///< "luminance", ...
    double error = 0;      ///< largest relative difference of a frequency
    bool reversed = false; ///< brighter lights are chosen less often
};

ChoiceLaw nearestLaw(const LightChoice &choice);

} // namespace grader
