// SPDX-License-Identifier: MIT
#pragma once

#include <grader/references/manifest.h>
#include <grader/references/render_process.h>
#include <grader/references/scene_file.h>

#include <functional>

namespace grader {

/// Size of the images of the folder references/; the height follows from the scene's.
constexpr int kReferenceWidth = 256;

/// The two images that a scene's reference consists of: same samples, different seeds.
/// \param width  0: the scene's own size
std::vector<ReferenceImage> planReference(const SceneFile &scene, int width);

/// Different for every text, below 2^31.
int seedOf(const std::string &text);

/// What renderReferences() did.
struct ReferenceRun {
    int rendered = 0;
    int kept = 0; ///< of which the manifest's entry still holds
    bool interrupted = false;
};

using Render = std::function<RenderEnd(const RenderJob &job)>;
/// Called before each image that is rendered, with its number of all.
using Announce = std::function<void(const ReferenceImage &image, int number, int count)>;

/// Renders every image of `plan` whose entry in the manifest of `folder` does not hold any more,
/// and writes the manifest after each. Entries of other images stay.
/// \throws GraderError  if one cannot be rendered or written; those before are kept
ReferenceRun renderReferences(const std::filesystem::path &scenes,
                              const std::filesystem::path &folder,
                              const std::vector<ReferenceImage> &plan, const Render &render,
                              const Announce &announce);

} // namespace grader
