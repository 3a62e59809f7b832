// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <filesystem>
#include <string>

namespace grader {

/// One call of the renderer, `nori`.
struct RenderJob {
    std::filesystem::path scene;
    std::string integrator; ///< empty: the scene's
    int samplesPerPixel = 0;
    int seed = 0;
    int width = 0;
    int height = 0;
    std::filesystem::path output; ///< the .exr to write, with moments; its folder exists
};

enum class RenderEnd { Done, Interrupted };

/// Renders in a process of its own, which shows its progress where standard error is a terminal.
/// Nothing is left behind but the finished image.
/// \param interrupted  asks for an early end
/// \throws GraderError  if `nori` cannot be started or fails; what it says is on standard error
RenderEnd runRenderer(const RenderJob &job, const std::atomic<bool> &interrupted);

/// Of `nori`, as it says itself in its images.
std::string rendererVersion();

} // namespace grader
