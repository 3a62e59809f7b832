// SPDX-License-Identifier: MIT
//
// Scenes without a closed form, as a camera sees them: judged against our own estimator. `shadow`
// takes most of the samples of a grading, as its dark tiles are noisy, and comes last.
#include <grader/checks/direct_ems_experiments.h>
#include <grader/checks/image_scene.h>

#include "check_groups.h"
#include "radiance_check.h"

namespace grader {

namespace {

RadianceCase image(const char *name, std::uint64_t seed, int repeats) {
    return imageCase(imageTemplate(name).fill(seed), repeats);
}

} // namespace

std::vector<Check> imageChecks() {
    return {
        radianceCheck(
            "scene", "A table under five lights looks as in our own estimator.",
            [](std::uint64_t seed) { return image("table", seed, 256); }, experimentWithOneLight),
        radianceCheck(
            "environment", "An environment map lights a scene as in our own estimator.",
            [](std::uint64_t seed) {
                RadianceCase test = image("sky", seed, 512);
                test.tilePassBound = 0.25;
                return test;
            },
            experimentWithOneLight),
        radianceCheck(
            "shadow", "A room with blocks and a light looks as in our own estimator.",
            [](std::uint64_t seed) { return image("box", seed, 256); }, experimentWithOneLight),
    };
}

} // namespace grader
