// SPDX-License-Identifier: MIT
#pragma once

#include <grader/references/scene_file.h>
#include <protocol/image.h>

#include <array>
#include <string>
#include <vector>

namespace grader {

/// Of a false alarm anywhere in the folder of references.
constexpr double kFamilyLevel = 1e-6;

/// Integrators that find a scene's light in another way than its own one does. Nothing that is
/// hit by a ray: point lights are only found by sampling them, so there it is the plain sum over
/// all lights.
std::vector<std::string> independentAlgorithms(const SceneFile &scene);

/// A scale within the first is what a reference is asked for; within the second where its scene is
/// too noisy for the first.
constexpr double kScaleAsked = 0.001;
constexpr double kScaleAtWorst = 0.005;

/// What a render by another algorithm says of a reference; the worst of three channels.
struct Agreement {
    double pValue = 1.0;     ///< of the tile tests of all channels together
    int tileSize = 0;        ///< [pixels]: the least at which all tiles are far enough from skew
    bool isTested = true;    ///< false: even the image's mean is too skewed
    bool hasScale = false;   ///< whether the following were asked for
    double scale = 0.0;      ///< relative error of the render's common factor
    double scaleBound = 0.0; ///< |scale| is below, at 1 - 1e-4
    double scaleMde = 0.0;   ///< minimal detectable |scale| at the level, with power 0.999
};

enum class Accord {
    Alike,
    Different,
    TooSkewed, ///< for a test
    TooNoisy,  ///< alike, but the scale's bound is above kScaleAtWorst
};

/// \param level  of a false alarm in this comparison
Accord accordOf(const Agreement &agreement, double level);

/// \param level  as above; for the minimal detectable scale
/// \throws GraderError  if an image lacks moments, sizes differ, or the reference is black
Agreement compareWithReference(const protocol::Image &render,
                               const std::array<protocol::Image, 2> &halves, double level);

/// Whether the two halves of a reference could be renders of one scene: all but the scale.
/// \throws GraderError  as above
Agreement compareHalves(const std::array<protocol::Image, 2> &halves);

} // namespace grader
