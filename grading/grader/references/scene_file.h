// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace grader {

/// What is to be known of a scene without rendering it.
struct SceneFile {
    std::string name;       ///< below the folder of scenes: `cbox/cbox_ems.xml`
    std::string integrator; ///< its `type`
    int width = 0;          ///< of the camera's image [pixels]
    int height = 0;
    bool hasPointLight = false;
    std::string digest; ///< SHA-256 over the text and every file that it names
};

/// \throws GraderError  naming the file, if it or one that it names cannot be read
SceneFile readSceneFile(const std::filesystem::path &folder, const std::string &name);

/// Every scene below a folder, sorted by name.
/// \throws GraderError  as above, or if there is none
std::vector<SceneFile> readSceneFiles(const std::filesystem::path &folder);

} // namespace grader
