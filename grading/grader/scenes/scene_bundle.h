// SPDX-License-Identifier: MIT
#pragma once

#include <protocol/request.h>
#include <statistics/filtered_tiles.h>

#include <filesystem>
#include <optional>
#include <vector>

namespace grader {

/// A scene file with everything that it names, as a probe is sent it.
struct SceneBundle {
    std::vector<protocol::File> files; ///< the scene first, called TestScene::kFileName
    int width = 0;                     ///< of the camera's image, as the scene says [pixels]
    int height = 0;
    std::optional<statistics::GaussianFilm> film; ///< nothing if the scene asks for another one
};

/// An image size that stands in for the scene's own; the field of view stays.
struct ImageSize {
    int width = 0;
    int height = 0;
};

/// \throws GraderError  naming the file, if it or one that it names cannot be read
SceneBundle readSceneBundle(const std::filesystem::path &file,
                            const std::optional<ImageSize> &size = std::nullopt);

} // namespace grader
