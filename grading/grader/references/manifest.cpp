// SPDX-License-Identifier: MIT
#include "manifest.h"

#include <grader/digest.h>
#include <grader/error.h>
#include <grader/text_file.h>
#include <grader/toml_text.h>

#include <fmt/core.h>

#include <limits>

namespace grader {

namespace {

namespace fs = std::filesystem;

constexpr char kHeading[] =
    "# Made by `norigrade references`: what each image was rendered from, and its SHA-256.\n"
    "# The two halves of a scene, a and b, have different seeds and the full number of samples.\n";

[[noreturn]] void fail(const fs::path &file, const toml::source_region &where,
                       const std::string &what) {
    throw GraderError(fmt::format("{}:{}: {}", file.string(), where.begin.line, what));
}

std::string textIn(const fs::path &file, const toml::table &table, const char *key) {
    if (const auto value = table[key].value_exact<std::string>())
        return *value;
    fail(file, table.source(), fmt::format("the text \"{}\" is missing", key));
}

int integerIn(const fs::path &file, const toml::table &table, const char *key) {
    const auto value = table[key].value_exact<std::int64_t>();
    if (value && *value >= 0 && *value <= std::numeric_limits<int>::max())
        return static_cast<int>(*value);
    fail(file, table.source(), fmt::format("the integer \"{}\" is missing", key));
}

} // namespace

std::vector<ReferenceImage> readManifest(const fs::path &folder) {
    const fs::path file = folder / "manifest.toml";
    std::vector<ReferenceImage> images;
    if (!fs::exists(file))
        return images;
    const toml::table document = parseToml(readTextFile(file), file.string());
    const toml::array *entries = document["image"].as_array();
    if (entries == nullptr)
        fail(file, document.source(), "lists no [[image]]");
    for (const toml::node &entry : *entries) {
        if (!entry.is_table())
            fail(file, entry.source(), "[[image]] is no table");
        const toml::table &table = *entry.as_table();
        images.push_back({textIn(file, table, "file"), textIn(file, table, "scene"),
                          textIn(file, table, "scene_digest"), textIn(file, table, "integrator"),
                          integerIn(file, table, "spp"), integerIn(file, table, "seed"),
                          integerIn(file, table, "width"), integerIn(file, table, "height"),
                          textIn(file, table, "version"), textIn(file, table, "sha256")});
    }
    return images;
}

void writeManifest(const fs::path &folder, const std::vector<ReferenceImage> &images) {
    std::string text = kHeading;
    for (const ReferenceImage &image : images) {
        text += fmt::format("\n[[image]]\n"
                            "file = '{}'\n"
                            "scene = '{}'\n"
                            "scene_digest = '{}'\n"
                            "integrator = '{}'\n"
                            "spp = {}\n"
                            "seed = {}\n"
                            "width = {}\n"
                            "height = {}\n"
                            "version = '{}'\n"
                            "sha256 = '{}'\n",
                            image.file, image.scene, image.sceneDigest, image.integrator,
                            image.samplesPerPixel, image.seed, image.width, image.height,
                            image.version, image.sha256);
    }
    writeTextFile(folder / "manifest.toml", text);
}

bool isSameRender(const ReferenceImage &rendered, const ReferenceImage &wanted) {
    return rendered.file == wanted.file && rendered.scene == wanted.scene &&
           rendered.sceneDigest == wanted.sceneDigest && rendered.integrator == wanted.integrator &&
           rendered.samplesPerPixel == wanted.samplesPerPixel && rendered.seed == wanted.seed &&
           rendered.width == wanted.width && rendered.height == wanted.height;
}

std::string faultOf(const fs::path &folder, const ReferenceImage &image) {
    const fs::path file = folder / image.file;
    if (!fs::exists(file))
        return fmt::format("{}: is missing", file.string());
    if (sha256Hex(readTextFile(file)) != image.sha256)
        return fmt::format("{}: is not the file that the manifest describes", file.string());
    return {};
}

} // namespace grader
