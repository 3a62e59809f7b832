// SPDX-License-Identifier: MIT
#include "scene_file.h"

#include <grader/digest.h>
#include <grader/error.h>
#include <grader/text_file.h>

#include <fmt/core.h>
#include <pugixml.hpp>

#include <algorithm>
#include <set>

namespace grader {

namespace {

namespace fs = std::filesystem;

/// Nori's own camera has these sizes where the scene is silent.
constexpr int kDefaultWidth = 1280;
constexpr int kDefaultHeight = 720;

int integerIn(pugi::xml_node object, const char *name, int otherwise) {
    return object.find_child_by_attribute("integer", "name", name)
        .attribute("value")
        .as_int(otherwise);
}

/// `name digest` of a file, as a line.
std::string lineOf(const std::string &name, const std::string &bytes) {
    return fmt::format("{} {}\n", sha256Hex(bytes), name);
}

} // namespace

SceneFile readSceneFile(const fs::path &folder, const std::string &name) {
    const fs::path path = folder / name;
    const std::string text = readTextFile(path);
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size());
    const pugi::xml_node scene = document.child("scene");
    if (!parsed || !scene)
        throw GraderError(fmt::format("{}: is no scene{}{}", path.string(), parsed ? "" : ": ",
                                      parsed ? "" : parsed.description()));
    const pugi::xml_node camera = scene.child("camera");
    SceneFile result;
    result.name = name;
    result.integrator = scene.child("integrator").attribute("type").value();
    result.width = integerIn(camera, "width", kDefaultWidth);
    result.height = integerIn(camera, "height", kDefaultHeight);
    result.hasPointLight = !scene.find_child_by_attribute("emitter", "type", "pointlight").empty();

    std::string lines = lineOf("scene", text);
    std::set<std::string> named;
    for (const pugi::xpath_node &node : document.select_nodes("//string[@name='filename']"))
        named.insert(node.node().attribute("value").value());
    for (const std::string &file : named)
        lines += lineOf(file, readTextFile(path.parent_path() / file));
    result.digest = sha256Hex(lines);
    return result;
}

std::vector<SceneFile> readSceneFiles(const fs::path &folder) {
    std::vector<std::string> names;
    std::error_code error;
    for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end;
         it.increment(error)) {
        if (it->path().extension() == ".xml")
            names.push_back(it->path().lexically_relative(folder).string());
    }
    if (error || names.empty())
        throw GraderError(fmt::format("{}: holds no scene", folder.string()));
    std::sort(names.begin(), names.end());
    std::vector<SceneFile> scenes;
    scenes.reserve(names.size());
    for (const std::string &name : names)
        scenes.push_back(readSceneFile(folder, name));
    return scenes;
}

} // namespace grader
