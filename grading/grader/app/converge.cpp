// SPDX-License-Identifier: MIT
#include <grader/app/interrupt.h>
#include <grader/app/terminal.h>
#include <grader/app/verbs.h>
#include <grader/converge/convergence_report.h>
#include <grader/converge/hand_in_renderer.h>
#include <grader/error.h>
#include <grader/images/read_image.h>
#include <grader/text_file.h>

#include <fmt/core.h>

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <set>
#include <thread>

namespace grader {

namespace {

namespace fs = std::filesystem;

ConvergencePlan planOf(const ConvergeCommand &command) {
    ConvergencePlan plan;
    std::set<fs::path> stems;
    for (const fs::path &file : command.scenes) {
        const fs::path whole = fs::absolute(file).lexically_normal();
        SceneFile scene = readSceneFile(whole.parent_path(), whole.filename().string());
        scene.name = whole.string();
        if (!stems.insert(whole.stem()).second)
            throw GraderError(fmt::format("{}: another scene has the same name", file.string()));
        plan.scenes.push_back(std::move(scene));
    }
    if (!command.references.empty() && plan.scenes.size() > 1)
        throw GraderError("--reference is of one scene: give one scene");
    plan.integrators = command.integrators;
    plan.samples = command.samples;
    std::sort(plan.samples.begin(), plan.samples.end());
    plan.samples.erase(std::unique(plan.samples.begin(), plan.samples.end()), plan.samples.end());
    if (plan.samples.size() < 2)
        throw GraderError("--spp: at least two different numbers of samples make a slope");
    plan.replicates = command.replicates;
    plan.width = command.width;
    plan.seed = command.seed;
    plan.references = command.references;
    return plan;
}

/// Tells which image is rendered, and when all will be done at the pace so far.
class Pace {
public:
    explicit Pace(const std::vector<ReferenceImage> &images) : m_images(images) {}

    void announce(const ReferenceImage &image, int number) {
        double left = 0.0;
        for (std::size_t i = static_cast<std::size_t>(number) - 1; i < m_images.size(); ++i)
            left += cost(m_images[i]);
        if (!m_started) {
            m_started = true;
            m_first = left;
        }
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
        std::string rest;
        if (const double done = m_first - left; done > 0.0)
            rest = fmt::format(", about {:.0f} s left", seconds / done * left);
        fmt::print(stderr, "{}/{} {}{}\n", number, m_images.size(), image.file, rest);
    }

private:
    static double cost(const ReferenceImage &image) {
        // Reading a scene and starting take about as long as this many samples per pixel.
        constexpr double kStart = 4.0;
        return image.samplesPerPixel + kStart;
    }

    const std::vector<ReferenceImage> &m_images;
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
    bool m_started = false;
    double m_first = 0.0;
};

ExitCode converge(const ConvergeCommand &command, ConvergencePlan plan) {
    const Sandbox sandbox;
    const std::atomic<bool> &interrupted = catchInterrupts();
    std::optional<HandInRenderer> handIn;
    if (!command.against.empty()) {
        fmt::print(stderr, "building {}\n", command.against.string());
        const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
        try {
            handIn.emplace(sandbox, command.against, cores);
        } catch (const GraderError &error) {
            complain(error.what());
            return ExitCode::Usage;
        }
        plan.against = ComparedHandIn{handIn->name(), handIn->digest()};
    }
    const std::vector<ReferenceImage> images = imagesOf(plan);
    const fs::path &out = command.out;
    Pace pace(images);
    const ReferenceRun run = renderReferences(
        "/", out, images,
        [&](const RenderJob &job) {
            return job.output.extension() == kPlanesExtension ? handIn->render(job, interrupted)
                                                              : runRenderer(job, interrupted);
        },
        [&](const ReferenceImage &image, int number, int) { pace.announce(image, number); });
    if (run.interrupted) {
        complain(fmt::format("interrupted: {} images are in {}; call again to go on",
                             run.rendered + run.kept, out.string()));
        return ExitCode::Interrupted;
    }
    const std::vector<Convergence> all = evaluate(plan, out, [&](const fs::path &file) {
        return file.extension() == kPlanesExtension ? readPlanes(file) : readImage(sandbox, file);
    });
    const std::string json = convergenceJson(plan, all);
    writeTextFile(out / "convergence.json", json);
    plot::writePlot(convergencePlot(all), out / "convergence");
    fmt::print("{}", command.json ? json : convergenceTable(all));
    fmt::print(stderr, "{}: convergence.json, .svg, .pdf, .png, .gp and .dat\n", out.string());
    const auto isRight = [](const Convergence &one) {
        return one.fit.isMonteCarlo();
    };
    const auto isWrong = [](const Convergence &one) {
        return one.fit.isOtherwise();
    };
    if (std::any_of(all.begin(), all.end(), isWrong))
        return ExitCode::CheckFailed;
    return std::all_of(all.begin(), all.end(), isRight) ? ExitCode::Done : ExitCode::NeedsHuman;
}

} // namespace

ExitCode run(const ConvergeCommand &command) {
    ConvergencePlan plan;
    try {
        plan = planOf(command);
    } catch (const GraderError &error) {
        complain(error.what());
        return ExitCode::Usage;
    }
    return converge(command, plan);
}

} // namespace grader
