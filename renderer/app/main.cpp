// SPDX-License-Identifier: MIT
#include <nori/emitter.h>
#include <nori/integrator.h>
#include <nori/parser.h>
#include <nori/render.h>
#include <nori/sampler.h>
#include <nori/scene.h>

#include <filesystem/resolver.h>
#include <fmt/core.h>

#include <signal.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "command_line.h"
#include "image_file.h"
#include "progress_bar.h"
#include "version.h"

namespace {

constexpr int kError = 1;
constexpr int kInterrupted = 130;

std::atomic<bool> cancelled{false}; // NOLINT: a signal handler can reach nothing else

extern "C" void onInterrupt(int) {
    if (cancelled.exchange(true))
        _exit(kInterrupted);
}

void warn(const std::string &message) {
    fmt::print(stderr, "Warning: {}\n", message);
}

std::unique_ptr<nori::Scene> loadScene(const CommandLine &line) {
    const std::string &file = line.scene;
    const std::filesystem::path path = file;
    if (nori::toLower(path.extension().string()) != ".xml")
        throw nori::NoriException("%s: a scene file (.xml) is expected", file);
    const std::string folder = path.has_parent_path() ? path.parent_path().string() : ".";
    nori::getFileResolver()->prepend(filesystem::path(folder));
    std::unique_ptr<nori::NoriObject> root(nori::loadFromXML(
        file, nori::SceneOverrides{nori::Vector2i(line.width, line.height), line.integrator}));
    if (root->getClassType() != nori::NoriObject::EScene)
        throw nori::NoriException("%s: holds a %s; a scene is expected", file,
                                  nori::NoriObject::classTypeName(root->getClassType()));
    return std::unique_ptr<nori::Scene>(static_cast<nori::Scene *>(root.release()));
}

/// What can be rendered, but is hardly meant.
void warnAboutContents(const nori::Scene &scene) {
    if (scene.getMeshes().empty())
        warn("the scene holds no mesh; only the background is seen");
}

/// Integrators such as `normals` need no light: only a black image tells.
void warnAboutImage(const nori::RenderResult &result, const nori::Scene &scene) {
    const bool black = std::all_of(result.image.data(), result.image.data() + result.image.size(),
                                   [](const nori::Color3f &c) { return (c == 0.0f).all(); });
    if (black && result.complete)
        warn(scene.getLights().empty() ? "the image is black, and the scene holds no light"
                                       : "the image is black");
    if (result.droppedSamples > 0)
        warn(fmt::format("{} samples were negative, infinite or not a number, and were dropped",
                         result.droppedSamples));
}

/// `Independent[sampleCount=4, seed=0]` -> `Independent`.
std::string className(const nori::NoriObject &object) {
    const std::string text = object.toString();
    return text.substr(0, text.find('['));
}

/// `Independent[sampleCount=4, seed=7]` -> `7`; a sampler of another form is given as it is.
std::string seedOf(const nori::Sampler &sampler) {
    std::string text = sampler.toString();
    const std::string key = "seed=";
    const size_t begin = text.find(key);
    if (begin == std::string::npos)
        return text;
    return text.substr(begin + key.size(), text.find_first_of(",]", begin) - begin - key.size());
}

/// The images' path without suffix. A suffix in --output is taken off: `nori a.xml --output b.exr`
/// can mean nothing else.
std::string stemOf(const CommandLine &line, int samplesPerPixel) {
    std::filesystem::path path = line.output;
    if (line.output.empty())
        return fmt::format("{}_{}",
                           std::filesystem::path(line.scene).replace_extension("").string(),
                           samplesPerPixel);
    const std::string suffix = nori::toLower(path.extension().string());
    return (suffix == ".exr" || suffix == ".png" ? path.replace_extension("") : path).string();
}

int run(const CommandLine &line) {
    const std::unique_ptr<nori::Scene> scene = loadScene(line);
    warnAboutContents(*scene);

    nori::RenderOptions options;
    options.samplesPerPixel = line.samplesPerPixel;
    options.seed = line.seed;
    options.threads = line.threads;
    options.moments = line.moments;
    options.cancelled = &cancelled;
    const int samplesPerPixel = line.samplesPerPixel > 0
                                    ? line.samplesPerPixel
                                    : static_cast<int>(scene->getSampler()->getSampleCount());
    const std::string stem = stemOf(line, samplesPerPixel);
    requireWritable(stem);

    const std::clock_t startCpu = std::clock();
    const auto start = std::chrono::steady_clock::now();
    nori::RenderResult result;
    {
        ProgressBar bar(std::filesystem::path(line.scene).filename().string(), !line.quiet);
        options.progress = [&bar](double fraction) {
            bar.update(fraction);
        };
        result = nori::render(*scene, options);
    }
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const double cpuSeconds =
        static_cast<double>(std::clock() - startCpu) / static_cast<double>(CLOCKS_PER_SEC);
    warnAboutImage(result, *scene);
    writeImage(result, stem,
               {{"spp", std::to_string(result.samplesPerPixel)},
                {"seed", line.seed ? std::to_string(*line.seed) : seedOf(*scene->getSampler())},
                {"integrator", className(*scene->getIntegrator())},
                {"version", std::string("nori ") + kNoriVersion},
                {"renderSeconds", fmt::format("{:.3f}", seconds)},
                {"cpuSeconds", fmt::format("{:.3f}", cpuSeconds)},
                {"partial", result.complete ? "no" : "yes"},
                {"comments", "Rendered by nori, part of norigrade"}});
    if (!line.quiet)
        fmt::print("{}.exr, {}.png: {} spp in {:.1f} s{}\n", stem, stem, result.samplesPerPixel,
                   seconds, result.complete ? "" : " (partial)");
    return result.complete ? 0 : kInterrupted;
}

} // namespace

int main(int argc, char **argv) {
    int exitCode = 0;
    const std::optional<CommandLine> line = parseCommandLine(argc, argv, exitCode);
    if (!line)
        return exitCode;

    struct sigaction action {};

    action.sa_handler = onInterrupt;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    signal(SIGXFSZ, SIG_IGN); // a file beyond the user's limit is an error of its writer
    try {
        return run(*line);
    } catch (const std::exception &error) {
        fmt::print(stderr, "Error: {}\n", error.what());
        return kError;
    }
}
