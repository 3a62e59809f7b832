// SPDX-License-Identifier: MIT
#include <grader/app/interrupt.h>
#include <grader/app/terminal.h>
#include <grader/app/verbs.h>
#include <grader/build/base.h>
#include <grader/error.h>
#include <grader/images/read_image.h>
#include <grader/references/references.h>
#include <grader/references/verification.h>
#include <grader/rubric/nearest_name.h>

#include <fmt/core.h>

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace grader {

namespace {

namespace fs = std::filesystem;

/// A folder that goes with this object.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string name = (fs::temp_directory_path() / "norigrade-references-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            throw GraderError(fmt::format("{}: no temporary folder can be made there",
                                          fs::temp_directory_path().string()));
        m_path = name;
    }

    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(m_path, ignored);
    }

    TemporaryFolder(const TemporaryFolder &) = delete;
    TemporaryFolder(TemporaryFolder &&) = delete;
    TemporaryFolder &operator=(const TemporaryFolder &) = delete;
    TemporaryFolder &operator=(TemporaryFolder &&) = delete;

    const fs::path &path() const { return m_path; }

private:
    fs::path m_path;
};

/// The scenes that were asked for. \throws GraderError  if there is none of a name
std::vector<SceneFile> chooseScenes(const fs::path &folder, const std::vector<std::string> &names) {
    const std::vector<SceneFile> all = readSceneFiles(folder);
    if (names.empty())
        return all;
    std::vector<std::string> known(all.size());
    std::transform(all.begin(), all.end(), known.begin(),
                   [](const SceneFile &scene) { return scene.name; });
    std::vector<SceneFile> chosen;
    chosen.reserve(names.size());
    for (const std::string &name : names) {
        const auto found = std::find(known.begin(), known.end(), name);
        if (found == known.end())
            throw GraderError(
                fmt::format("there is no scene \"{}\"{}", name, suggestion(name, known)));
        chosen.push_back(all[static_cast<std::size_t>(found - known.begin())]);
    }
    return chosen;
}

void announce(const ReferenceImage &image, int number, int count) {
    fmt::print(stderr, "{}/{} {}: {} x {}, {} spp, {}\n", number, count, image.file, image.width,
               image.height, image.samplesPerPixel, image.integrator);
}

ExitCode render(const fs::path &scenes, const fs::path &out,
                const std::vector<ReferenceImage> &plan, const std::atomic<bool> &interrupted) {
    const ReferenceRun run = renderReferences(
        scenes, out, plan, [&](const RenderJob &job) { return runRenderer(job, interrupted); },
        announce);
    fmt::print("{}: {} images rendered, {} were there{}\n", out.string(), run.rendered, run.kept,
               run.interrupted ? "; interrupted, call again to go on" : "");
    return run.interrupted ? ExitCode::Interrupted : ExitCode::Done;
}

/// What an agreement comes to, in words.
std::string sentenceOf(const Agreement &agreement, Accord accord) {
    switch (accord) {
    case Accord::Different:
        return "DIFFERENT";
    case Accord::TooSkewed:
        return "too skewed to tell";
    case Accord::TooNoisy:
        return "alike, scale too noisy to tell";
    case Accord::Alike:
        break;
    }
    if (!agreement.hasScale)
        return "alike";
    return fmt::format("alike, scale within {:.1f} %",
                       100 * (agreement.scaleBound <= kScaleAsked ? kScaleAsked : kScaleAtWorst));
}

/// Compares the references with renders by other algorithms and prints a row for each.
class Verifier {
public:
    Verifier(fs::path scenes, fs::path out, std::size_t sceneCount,
             const std::atomic<bool> &interrupted)
        : m_scenes(std::move(scenes)),
          m_out(std::move(out)),
          m_level(kFamilyLevel / (kTestsPerScene * static_cast<double>(sceneCount))),
          m_interrupted(interrupted) {}

    ExitCode run(const std::vector<SceneFile> &scenes) {
        fmt::print(
            "Tile tests at a level of {:.2g} each ({:g} of all). Scale in percent: estimate, "
            "upper bound at 99.99 %,\nminimal detectable at the level with power 0.999.\n\n"
            "{:30} {:14} {:>5} {:>8} {:>5} {:>7} {:>7} {:>7}\n",
            m_level, kFamilyLevel, "scene", "against", "spp", "p", "tile", "scale", "bound", "mde");
        for (const SceneFile &scene : scenes) {
            const std::vector<ReferenceImage> plan = planReference(scene, 0);
            for (std::size_t i = 0; i < m_halves.size(); ++i)
                m_halves[i] = readImage(m_sandbox, m_out / plan[i].file);
            print(scene.name, "its other half", plan[0].samplesPerPixel, compareHalves(m_halves));
            for (const std::string &algorithm : independentAlgorithms(scene)) {
                if (verify(scene, algorithm, plan[0].samplesPerPixel) == RenderEnd::Interrupted)
                    return ExitCode::Interrupted;
            }
        }
        return m_allAlike ? ExitCode::Done : ExitCode::CheckFailed;
    }

private:
    /// The halves, two algorithms, and each of these again with more samples.
    static constexpr double kTestsPerScene = 5;
    /// Times as many samples, where as many as the reference has do not settle the scale.
    static constexpr int kMore = 4;

    RenderEnd verify(const SceneFile &scene, const std::string &algorithm, int samplesPerPixel) {
        Agreement agreement;
        for (const int factor : {1, kMore}) {
            const fs::path file = m_temporary.path() / "render.exr";
            const int count = factor * samplesPerPixel;
            const int seed = seedOf(fmt::format("{} of {}, {}", algorithm, scene.name, count));
            if (runRenderer({m_scenes / scene.name, algorithm, count, seed, m_halves[0].width,
                             m_halves[0].height, file},
                            m_interrupted) == RenderEnd::Interrupted)
                return RenderEnd::Interrupted;
            agreement = compareWithReference(readImage(m_sandbox, file), m_halves, m_level);
            print(scene.name, algorithm, count, agreement);
            if (accordOf(agreement, m_level) != Accord::TooNoisy)
                break;
        }
        m_allAlike = m_allAlike && accordOf(agreement, m_level) == Accord::Alike;
        return RenderEnd::Done;
    }

    void print(const std::string &scene, const std::string &other, int samplesPerPixel,
               const Agreement &agreement) {
        const Accord accord = accordOf(agreement, m_level);
        // noise alone can be mended with more samples
        m_allAlike = m_allAlike && accord != Accord::Different && accord != Accord::TooSkewed;
        const std::string scale =
            agreement.hasScale ? fmt::format("{:+7.3f} {:7.3f} {:7.3f}", 100 * agreement.scale,
                                             100 * agreement.scaleBound, 100 * agreement.scaleMde)
                               : std::string(23, ' ');
        fmt::print("{:30} {:14} {:5} {:8.2g} {:5} {} {}\n", scene, other, samplesPerPixel,
                   agreement.pValue, agreement.tileSize, scale, sentenceOf(agreement, accord));
        std::fflush(stdout);
    }

    fs::path m_scenes;
    fs::path m_out;
    double m_level; ///< of each test
    const std::atomic<bool> &m_interrupted;
    Sandbox m_sandbox;
    TemporaryFolder m_temporary;
    std::array<protocol::Image, 2> m_halves; ///< of the current scene
    bool m_allAlike = true;
};

} // namespace

ExitCode run(const ReferencesCommand &command) {
    const std::atomic<bool> &interrupted = catchInterrupts();
    const fs::path scenes = projectFolder() / "scenes" / "assignment-2";
    const fs::path out =
        command.out.empty() ? projectFolder() / "references" / "assignment-2" : command.out;
    const int width = command.fullSize ? 0 : kReferenceWidth;
    std::vector<SceneFile> chosen;
    try {
        chosen = chooseScenes(scenes, command.scenes);
    } catch (const GraderError &error) {
        complain(error.what());
        return ExitCode::Usage;
    }
    if (command.verify)
        return Verifier(scenes, out, readSceneFiles(scenes).size(), interrupted).run(chosen);
    std::vector<ReferenceImage> plan;
    for (const SceneFile &scene : chosen) {
        for (ReferenceImage &image : planReference(scene, width))
            plan.push_back(std::move(image));
    }
    return render(scenes, out, plan, interrupted);
}

} // namespace grader
