// SPDX-License-Identifier: MIT
#pragma once

#include <grader/checks/check.h>
#include <grader/checks/radiance_diagnosis.h>
#include <grader/checks/radiance_samples.h>
#include <grader/scenes/test_scene.h>

#include <limits>
#include <optional>
#include <vector>

namespace grader {

struct TestRay {
    Vector3d origin;
    Vector3d direction; ///< unit
};

/// A scene, rays into it or its camera's pixels, and what Integrator::Li must be on average along
/// each.
struct RadianceCase {
    std::vector<protocol::File> files; ///< of the scene, which is called TestScene::kFileName
    int columns = 16;               ///< rays stand in rows of this many, neighbours close together
    std::vector<TestRay> rays;      ///< shape [rows, columns]; empty: the camera's pixels
    int pixelRows = 0;              ///< of the camera, whose pixels stand in `columns`
    std::vector<Vector3d> expected; ///< closed form per ray; empty: our own estimator
    int repeats = 2048;             ///< samples per ray at the third look
    CaseDiagnoses diagnoses;        ///< what may be wrong
    double passBound = 0.02;        ///< a pass states that the common factor is off by less
    double tilePassBound = std::numeric_limits<double>::infinity(); ///< and that every tile is

    /// Per side; a closed form has no noise of its own, and smaller tiles will do.
    int tileSize() const { return rays.empty() ? 8 : 4; }

    /// Rays or pixels.
    std::size_t places() const {
        return rays.empty() ? static_cast<std::size_t>(columns) * pixelRows : rays.size();
    }
};

/// Sets of three stages that judgeRadiance() may accuse after: the image as a whole, tiles that
/// stand out, pixels that stand out.
constexpr int kRadianceLocks = 3;

/// Number of the first stage that judges what stands out; that of the image as a whole is 0.
constexpr int kSuspectsFirstStage = 3;

/// Judges the mean of Li per ray or pixel: global scale, sum of squares and worst tile per channel,
/// with skewness correction, tolerance and triple lock; every stage takes up to kLooks looks at
/// samples that double. Where there is no closed form, our own estimator is compared at equal
/// samples, where skewness cancels, and with more. What stands out of an image that is right as a
/// whole is looked at again, with fresh samples (statistics.md §2b). Code that is too slow for all
/// samples is judged on fewer.
CheckResult judgeRadiance(CheckContext &context, const RadianceCase &test);

/// A request for `repeats` samples of Li along every ray, or those named in `which`.
protocol::RequestGroup radianceRequest(const RadianceCase &test, int repeats, std::uint64_t seed,
                                       const std::vector<std::size_t> &which = {});

/// Rays that meet a parallelogram() on a jittered `columns` x `columns` grid, a margin of 5 % left
/// free, from `distance` in front of it with random slant.
std::vector<TestRay> raysOnto(const TestMesh &parallelogram, int columns, double distance,
                              SceneRandom &random);

/// Where a ray meets the plane of a face. \return  the point
Vector3d hitPoint(const TestRay &ray, const TestMesh &mesh, std::size_t face = 0);

} // namespace grader
