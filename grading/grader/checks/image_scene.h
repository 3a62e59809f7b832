// SPDX-License-Identifier: MIT
#pragma once

#include <grader/checks/radiance_case.h>
#include <grader/scenes/scene_template.h>

#include <string>
#include <vector>

namespace grader {

constexpr int kImageSize = 32; ///< pixels per side, as in the templates

/// The template scenes/grading/`name`.xml.
SceneTemplate imageTemplate(const std::string &name);

/// The pixels of a scene's camera, judged against our own estimator.
/// \param repeats  samples per pixel at the third look
RadianceCase imageCase(std::vector<protocol::File> files, int repeats);

/// A request for all pixels of the scene in the folder `folder` (empty: at the top).
protocol::Request imageRequest(const std::string &folder, int repeats, std::uint64_t seed);

} // namespace grader
