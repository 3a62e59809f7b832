// SPDX-License-Identifier: MIT
#pragma once

#include <grader/checks/radiance_samples.h>
#include <grader/diagnosis/guess.h>
#include <grader/scenes/test_scene.h>

#include <string>
#include <vector>

namespace grader {

/// What the mean of Li would be along each ray under a known mistake.
struct Hypothesis {
    const char *diagnosis;
    std::vector<Vector3d> expected;
};

/// What a radiance case knows of the mistakes that it shows.
struct CaseDiagnoses {
    int lightCount = 1;                      ///< a factor of this much has a name
    const char *black = "ems.black";         ///< where everything is black
    const char *other = "ems.part_of_image"; ///< where nothing else is likely
    double otherFit = kVagueFit;
    bool isNoisy = false; ///< with right code samples differ: without, numbers are used again
    std::vector<Hypothesis> hypotheses;
};

/// Explains an image by known means and by named common factors: the part of the weighted squares
/// of the deviation that each takes away.
std::vector<Guess> guessRadiance(const RadianceMoments &student, const RadianceMoments &expected,
                                 const CaseDiagnoses &known);

} // namespace grader
