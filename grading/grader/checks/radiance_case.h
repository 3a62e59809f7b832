// SPDX-License-Identifier: MIT
#pragma once

#include <grader/checks/check.h>
#include <grader/scenes/test_scene.h>

#include <vector>

namespace grader {

struct TestRay {
    Vector3d origin;
    Vector3d direction; ///< unit
};

/// A scene, rays into it, and what Integrator::Li must be on average along each.
struct RadianceCase {
    TestScene scene;
    int columns = 16;          ///< rays stand in rows of this many, neighbours close together
    std::vector<TestRay> rays; ///< shape [rows, columns]
    std::vector<Vector3d>
        expected;            ///< closed form per ray; empty: our own estimator, equal samples
    int repeats = 2048;      ///< samples per ray at the first stage
    int lightCount = 1;      ///< for the diagnosis: a factor of this much has a name
    double passBound = 0.02; ///< a pass states that the common factor is off by less
};

/// Judges the mean of Li per ray: global scale, sum of squares and worst tile per channel, with
/// skewness correction, tolerance and triple lock (statistics.md §2b). Code that is too slow for
/// all samples is judged on fewer.
///
CheckResult judgeRadiance(CheckContext &context, const RadianceCase &test);

/// A request for `repeats` samples of Li along every ray.
protocol::RequestGroup radianceRequest(const RadianceCase &test, int repeats, std::uint64_t seed);

/// Rays that meet a parallelogram() on a jittered `columns` x `columns` grid, a margin of 5 % left
/// free, from `distance` in front of it with random slant.
std::vector<TestRay> raysOnto(const TestMesh &parallelogram, int columns, double distance,
                              SceneRandom &random);

/// Where a ray meets the plane of a face. \return  the point
Vector3d hitPoint(const TestRay &ray, const TestMesh &mesh, std::size_t face = 0);

} // namespace grader
