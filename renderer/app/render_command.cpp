// SPDX-License-Identifier: MIT
#include "render_command.h"

#include <nori/emitter.h>
#include <nori/integrator.h>
#include <nori/parser.h>
#include <nori/render.h>
#include <nori/sampler.h>
#include <nori/scene.h>

#include <filesystem/resolver.h>
#include <fmt/core.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <memory>

#include "image_file.h"
#include "progress_bar.h"
#include "version.h"
#include "view_command.h"
#include <preview/pass_schedule.h>
#include <preview/reference_file.h>
#include <preview/render_job.h>

namespace {

void warn(const std::string &message) {
    fmt::print(stderr, "Warning: {}\n", message);
}

std::unique_ptr<nori::Scene> loadScene(const CommandLine &line) {
    const std::string &file = line.file;
    const std::filesystem::path path = file;
    if (nori::toLower(path.extension().string()) != ".xml")
        throw nori::NoriException("%s: a scene (.xml) or an image (.exr) is expected", file);
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
        return fmt::format("{}_{}", std::filesystem::path(line.file).replace_extension("").string(),
                           samplesPerPixel);
    const std::string suffix = nori::toLower(path.extension().string());
    return (suffix == ".exr" || suffix == ".png" ? path.replace_extension("") : path).string();
}

/// Writes the image of a job as soon as it is there, whatever the window does.
class ImageWriter {
public:
    ImageWriter(const CommandLine &line, const nori::Scene &scene, std::string stem)
        : m_line(line),
          m_scene(scene),
          m_stem(std::move(stem)),
          m_name(std::filesystem::path(line.file).filename().string()),
          m_bar(std::make_unique<ProgressBar>(m_name, !line.quiet)) {}

    const std::string &sceneName() const { return m_name; }

    void showProgress(double fraction) { m_bar->update(fraction); }

    void finish(const nori::RenderResult &result, double seconds) {
        m_bar.reset();
        const double cpuSeconds =
            static_cast<double>(std::clock() - m_startCpu) / static_cast<double>(CLOCKS_PER_SEC);
        warnAboutImage(result, m_scene);
        const std::optional<int> seed = m_line.seed;
        writeImage(result, m_stem,
                   {{"spp", std::to_string(result.samplesPerPixel)},
                    {"seed", seed ? std::to_string(*seed) : seedOf(*m_scene.getSampler())},
                    {"integrator", className(*m_scene.getIntegrator())},
                    {"version", std::string("nori ") + kNoriVersion},
                    {"renderSeconds", fmt::format("{:.3f}", seconds)},
                    {"cpuSeconds", fmt::format("{:.3f}", cpuSeconds)},
                    {"partial", result.complete ? "no" : "yes"},
                    {"comments", "Rendered by nori, part of norigrade"}});
        if (!m_line.quiet)
            fmt::print("{}.exr, {}.png: {} spp in {:.1f} s{}\n", m_stem, m_stem,
                       result.samplesPerPixel, seconds, result.complete ? "" : " (partial)");
        std::fflush(stdout); // the window may stay open for hours
    }

private:
    const CommandLine &m_line;
    const nori::Scene &m_scene;
    std::string m_stem;
    std::string m_name;
    std::unique_ptr<ProgressBar> m_bar;
    std::clock_t m_startCpu = std::clock();
};

void renderInWindow(const CommandLine &line, const std::string &name, preview::RenderJob &job) {
    preview::ViewModel model(name, &job);
    if (!line.reference.empty()) {
        model.setReference(nori::Bitmap(line.reference), line.reference); // its errors matter
    } else {
        const std::string found = preview::findReference(line.file);
        const std::string relative = std::filesystem::proximate(found).string();
        if (!found.empty())
            model.loadReference(relative.size() < found.size() ? relative : found);
    }
    model.setLook(line.look);
    preview::show(model, line.window);
    if (!job.isInterrupted() && job.progress().phase != preview::Phase::Finished && !line.quiet)
        fmt::print(stderr, "The window is closed, the render goes on. Ctrl-C stops it and saves "
                           "what is there.\n");
}

} // namespace

int renderScene(const CommandLine &line, std::atomic<bool> &cancelled) {
    const std::unique_ptr<nori::Scene> scene = loadScene(line);
    warnAboutContents(*scene);

    nori::RenderOptions options;
    options.samplesPerPixel = line.samplesPerPixel;
    options.seed = line.seed;
    options.threads = line.threads;
    options.moments = line.moments;
    const int samplesPerPixel = line.samplesPerPixel > 0
                                    ? line.samplesPerPixel
                                    : static_cast<int>(scene->getSampler()->getSampleCount());
    const std::string stem = stemOf(line, samplesPerPixel);
    requireWritable(stem);

    ImageWriter writer(line, *scene, stem);
    options.progress = [&writer](double fraction) {
        writer.showProgress(fraction);
    };
    bool complete = false;
    const auto finish = [&](const nori::RenderResult &result, double seconds) {
        complete = result.complete;
        writer.finish(result, seconds);
    };
    if (opensWindow(line)) {
        preview::RenderJob job(*scene, options, preview::passSchedule(samplesPerPixel), cancelled,
                               finish);
        try {
            renderInWindow(line, writer.sceneName(), job);
        } catch (const std::exception &error) {
            if (job.isStarted() || line.windowing == Windowing::Always)
                throw;
            warn(fmt::format("no window is opened: {}", error.what()));
        }
        if (job.isStarted()) {
            job.wait();
            return complete ? 0 : kInterrupted;
        }
    }
    preview::RenderJob(*scene, options, {}, cancelled, finish).run();
    return complete ? 0 : kInterrupted;
}
