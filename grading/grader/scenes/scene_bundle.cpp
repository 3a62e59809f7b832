// SPDX-License-Identifier: MIT
#include "scene_bundle.h"

#include <grader/error.h>
#include <grader/scenes/test_scene.h>
#include <grader/text_file.h>

#include <fmt/core.h>
#include <pugixml.hpp>

#include <map>
#include <sstream>

namespace grader {

namespace {

namespace fs = std::filesystem;

/// Nori's own camera has these sizes where the scene is silent.
constexpr int kDefaultWidth = 1280;
constexpr int kDefaultHeight = 720;

/// The value of `<integer name="NAME" value="..."/>` of an object; made if there is none.
pugi::xml_attribute integerOf(pugi::xml_node object, const char *name) {
    pugi::xml_node property = object.find_child_by_attribute("integer", "name", name);
    if (!property) {
        property = object.append_child("integer");
        property.append_attribute("name") = name;
        property.append_attribute("value");
    }
    return property.attribute("value");
}

std::optional<statistics::GaussianFilm> filmOf(pugi::xml_node camera) {
    statistics::GaussianFilm film;
    const pugi::xml_node filter = camera.child("rfilter");
    if (!filter)
        return film;
    if (std::string(filter.attribute("type").value()) != "gaussian")
        return std::nullopt;
    const auto number = [&](const char *name, double otherwise) {
        return filter.find_child_by_attribute("float", "name", name)
            .attribute("value")
            .as_double(otherwise);
    };
    film.radius = number("radius", film.radius);
    film.stddev = number("stddev", film.stddev);
    return film;
}

} // namespace

SceneBundle readSceneBundle(const fs::path &file, const std::optional<ImageSize> &size) {
    const std::string text = readTextFile(file);
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size());
    const pugi::xml_node scene = document.child("scene");
    const pugi::xml_node camera = scene.child("camera");
    if (!parsed || !camera)
        throw GraderError(fmt::format("{}: is no scene with a camera{}{}", file.string(),
                                      parsed ? "" : ": ", parsed ? "" : parsed.description()));
    SceneBundle bundle;
    pugi::xml_attribute width = integerOf(camera, "width");
    pugi::xml_attribute height = integerOf(camera, "height");
    bundle.width = width.as_int(kDefaultWidth);
    bundle.height = height.as_int(kDefaultHeight);
    width = size ? size->width : bundle.width;
    height = size ? size->height : bundle.height;
    bundle.film = filmOf(camera);

    // Names may lead out of the scene's folder, which a probe does not allow.
    std::map<std::string, std::string> renamed;
    for (const pugi::xpath_node &node : document.select_nodes("//string[@name='filename']")) {
        pugi::xml_attribute value = node.node().attribute("value");
        const std::string name = value.value();
        auto known = renamed.find(name);
        if (known == renamed.end()) {
            const std::string plain =
                fmt::format("file{}{}", renamed.size(), fs::path(name).extension().string());
            known = renamed.emplace(name, plain).first;
            bundle.files.push_back({plain, readTextFile(file.parent_path() / name)});
        }
        value = known->second.c_str();
    }
    std::ostringstream xml;
    document.save(xml);
    bundle.files.insert(bundle.files.begin(), {TestScene::kFileName, xml.str()});
    return bundle;
}

} // namespace grader
