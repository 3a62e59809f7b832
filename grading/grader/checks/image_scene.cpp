// SPDX-License-Identifier: MIT
#include "image_scene.h"

#include <grader/build/base.h>

#include <utility>

namespace grader {

SceneTemplate imageTemplate(const std::string &name) {
    return SceneTemplate(projectFolder() / "scenes/grading" / (name + ".xml"));
}

RadianceCase imageCase(std::vector<protocol::File> files, int repeats) {
    RadianceCase test;
    test.files = std::move(files);
    test.columns = kImageSize;
    test.pixelRows = kImageSize;
    test.repeats = repeats;
    test.tilePassBound = 0.15;
    return test;
}

protocol::Request imageRequest(const std::string &folder, int repeats, std::uint64_t seed) {
    protocol::Request request = radianceRequest(imageCase({}, repeats), repeats, seed).requests[0];
    if (!folder.empty())
        request.text = folder + "/" + request.text;
    return request;
}

} // namespace grader
