// SPDX-License-Identifier: MIT
#include "references.h"

#include <grader/digest.h>
#include <grader/error.h>
#include <grader/text_file.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace grader {

namespace {

namespace fs = std::filesystem;

constexpr int kSamplesPerPixel = 1024;
/// Scenes with more noise than others.
constexpr std::pair<const char *, int> kMoreSamples[] = {{"serapis/serapis_env.xml", 2048},
                                                         {"serapis/serapis_env_map.xml", 2048}};
constexpr std::array<const char *, 2> kHalves = {"a", "b"};

int samplesFor(const std::string &scene) {
    for (const auto &[name, samples] : kMoreSamples) {
        if (scene == name)
            return samples;
    }
    return kSamplesPerPixel;
}

} // namespace

int seedOf(const std::string &text) {
    return static_cast<int>(std::stoul(sha256Hex(text).substr(0, 8), nullptr, 16) & 0x7fffffffu);
}

std::vector<ReferenceImage> planReference(const SceneFile &scene, int width) {
    std::vector<ReferenceImage> images;
    for (const char *half : kHalves) {
        ReferenceImage image;
        image.file =
            fmt::format("{}_{}.exr", fs::path(scene.name).replace_extension("").string(), half);
        image.scene = scene.name;
        image.sceneDigest = scene.digest;
        image.integrator = scene.integrator;
        image.samplesPerPixel = samplesFor(scene.name);
        image.seed = seedOf(fmt::format("reference {} of {}", half, scene.name));
        image.width = width > 0 ? width : scene.width;
        image.height = width > 0 ? static_cast<int>(std::lround(static_cast<double>(width) *
                                                                scene.height / scene.width))
                                 : scene.height;
        image.version = rendererVersion();
        images.push_back(std::move(image));
    }
    return images;
}

ReferenceRun renderReferences(const fs::path &scenes, const fs::path &folder,
                              const std::vector<ReferenceImage> &plan, const Render &render,
                              const Announce &announce) {
    std::vector<ReferenceImage> manifest = readManifest(folder);
    ReferenceRun run;
    int number = 0;
    for (ReferenceImage wanted : plan) {
        ++number;
        const auto entry =
            std::find_if(manifest.begin(), manifest.end(),
                         [&](const ReferenceImage &image) { return image.file == wanted.file; });
        if (entry != manifest.end() && isSameRender(*entry, wanted) &&
            faultOf(folder, *entry).empty()) {
            ++run.kept;
            continue;
        }
        announce(wanted, number, static_cast<int>(plan.size()));
        const fs::path file = folder / wanted.file;
        std::error_code error;
        fs::create_directories(file.parent_path(), error);
        if (error)
            throw GraderError(fmt::format("{}: cannot be made: {}", file.parent_path().string(),
                                          error.message()));
        if (render({scenes / wanted.scene, wanted.integrator, wanted.samplesPerPixel, wanted.seed,
                    wanted.width, wanted.height, file}) == RenderEnd::Interrupted) {
            run.interrupted = true;
            return run;
        }
        wanted.sha256 = sha256Hex(readTextFile(file));
        if (entry != manifest.end())
            *entry = wanted;
        else
            manifest.push_back(wanted);
        std::sort(manifest.begin(), manifest.end(),
                  [](const auto &a, const auto &b) { return a.file < b.file; });
        writeManifest(folder, manifest);
        ++run.rendered;
    }
    return run;
}

} // namespace grader
