// SPDX-License-Identifier: MIT
//
// The shadow of a wall far away: it covers most directions, so that many samples are needed, and
// wrong code takes about as long here as with an image.
#include <numbers>

#include "check_groups.h"
#include "radiance_check.h"
#include "room.h"

namespace grader {

namespace {

/// A wall so far away that its shadow is lost when the environment is taken to be at a finite
/// distance.
RadianceCase farShadow(std::uint64_t seed) {
    Room room(seed);
    RadianceCase test = room.onFloor();
    const TestMesh wall =
        parallelogram({-9000, -9000, 3000}, {0, 18000, 0}, {18000, 0, 0}).transformed(room.pose);
    const Vector3d radiance(1.3, 1.1, 0.9);
    room.scene.addMesh(wall, {0.5, 0.5, 0.5});
    room.scene.addEnvironment(radiance);
    Hypothesis unshadowed{"ems.far_shadow", {}};
    for (const TestRay &ray : test.rays) {
        const double hidden = polygonIrradiance(hitPoint(ray, room.floor),
                                                room.floor.geometricNormal(0), wall.positions) /
                              std::numbers::pi;
        test.expected.emplace_back(room.albedo.cwiseProduct(radiance) * (1 - hidden));
        unshadowed.expected.emplace_back(room.albedo.cwiseProduct(radiance));
    }
    test.diagnoses.hypotheses = {std::move(unshadowed)};
    test.files = room.scene.files();
    test.repeats = 8192;
    test.passBound = 0.03;
    return test;
}

} // namespace

std::vector<Check> farShadowChecks() {
    return {
        radianceCheck("far_shadow", "A wall thousands of units away still hides the environment.",
                      farShadow),
    };
}

} // namespace grader
