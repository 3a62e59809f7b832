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
    /// Of each light to each ray, if it is chosen with certainty; shape [rays][lights].
    std::vector<std::vector<Vector3d>> contributions;
    std::vector<double> frequencies; ///< per light, of the recognised samples
    double recognised = 0; ///< part of the samples with light in them that come from one light
    std::optional<CheckResult> failure;

    bool isUniform() const;
};

LightChoice measureChoice(CheckContext &context);

/// The lights of measureEveryKind(), by index.
constexpr std::size_t kPoint = 0, kFirstMesh = 1, kSecondMesh = 2, kEnvironment = 3, kKinds = 4;

/// The same of a scene with lights of all kinds; without a closed form and contributions.
LightChoice measureEveryKind(CheckContext &context);

/// Seven lights of one intensity, where a choice by radiance is a uniform one: nothing is measured.
LightChoice equalLights(std::uint64_t seed);

/// The weight that the frequencies follow best.
struct ChoiceLaw {
    std::string name;                  ///< "luminance", ...
    double error = 0;                  ///< largest relative difference of a frequency
    bool reversed = false;             ///< brighter lights are chosen less often
    bool reciprocal = false;           ///< they follow the reciprocal of one of the laws
    std::vector<double> probabilities; ///< per light
};

ChoiceLaw nearestLaw(const LightChoice &choice);

/// Variance of one sample of one light, summed over rays and channels: sum c_i^2 / p_i - mean^2.
double exactVariance(const LightChoice &choice, const std::vector<double> &probabilities);

} // namespace grader
