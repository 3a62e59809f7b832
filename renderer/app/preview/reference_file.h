// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace preview {

/// The image that renders of a scene can be compared with: `SCENE_reference.exr` or
/// `SCENE_ref.exr` beside it, or `SCENE`, these, or `SCENE_a.exr` in a folder `references`, there
/// or in a folder above, below which the scene's folders may be repeated.
/// \return  its path; empty if there is none
std::string findReference(const std::string &sceneFile);

} // namespace preview
