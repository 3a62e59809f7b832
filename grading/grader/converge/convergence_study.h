// SPDX-License-Identifier: MIT
#pragma once

#include <grader/references/references.h>
#include <protocol/image.h>
#include <statistics/convergence.h>
#include <statistics/replicates.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace grader {

/// Somebody's code beside ours.
struct ComparedHandIn {
    std::string name; ///< for labels
    std::string digest;
};

/// What is to be measured: every integrator on every scene.
struct ConvergencePlan {
    std::vector<SceneFile> scenes;        ///< names are paths
    std::vector<std::string> integrators; ///< empty: each scene's own
    std::vector<int> samples;             ///< per pixel, growing
    int replicates = 8;
    int width = 0; ///< of the images [pixels]; the height follows from the scene's
    std::string seed;
    /// Two independent halves of the one scene's reference; empty: rendered here.
    std::vector<std::filesystem::path> references;
    /// Renders every scene as well, with the scene's own integrator.
    std::optional<ComparedHandIn> against;
};

/// The images that a plan needs, in the order in which they are rendered: two reference halves per
/// scene, of 4 times the most samples, then the replicates. Those of a hand-in end in
/// kPlanesExtension.
std::vector<ReferenceImage> imagesOf(const ConvergencePlan &plan);

/// One integrator on one scene.
struct Convergence {
    std::string label; ///< `cbox_ems direct_ems`
    std::string scene;
    std::string integrator; ///< or the hand-in's name
    statistics::ConvergenceFit fit;
    /// Variance of replicates over what their samples' variances say, at the most samples; none
    /// below 2 samples.
    std::optional<statistics::RatioEstimate> betweenWithin;
    double variance = 0.0;   ///< of one sample, mean over pixels and channels
    double cpuSeconds = 0.0; ///< of one sample of each pixel
    double efficiency = 0.0; ///< 1 / (variance * cpuSeconds)
    /// Variance of the plan's first integrator and scene over this one's, where both show the same
    /// image and the samples are enough to tell.
    std::optional<statistics::RatioEstimate> gain;
};

using LoadImage = std::function<protocol::Image(const std::filesystem::path &file)>;

/// Evaluates rendered images.
/// \param folder  where imagesOf() stand
/// \throws GraderError  naming the scene, if an image lacks moments or a reference is too noisy
std::vector<Convergence> evaluate(const ConvergencePlan &plan, const std::filesystem::path &folder,
                                  const LoadImage &load);

} // namespace grader
