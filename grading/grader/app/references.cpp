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

/// A scale within these is what a reference is asked for; the second where it is too noisy for the
/// first.
constexpr double kScaleAsked = 0.001;
constexpr double kScaleAtWorst = 0.005;

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
std::string verdictOf(const Agreement &agreement, double level, bool withScale) {
    if (!agreement.isTested)
        return "too skewed to tell";
    if (agreement.pValue < level)
        return "DIFFERENT";
    if (!withScale)
        return "alike";
    for (const double asked : {kScaleAsked, kScaleAtWorst}) {
        if (agreement.scaleBound <= asked)
            return fmt::format("scale within {:.1f} %", 100 * asked);
    }
    return "scale too noisy to tell";
}

/// \return  whether it is as it should be
bool print(const std::string &scene, const std::string &algorithm, const Agreement &agreement,
           double level, bool withScale) {
    const std::string verdict = verdictOf(agreement, level, withScale);
    const std::string scale =
        withScale ? fmt::format("{:+8.3f} {:8.3f} {:8.3f}", 100 * agreement.scale,
                                100 * agreement.scaleBound, 100 * agreement.scaleMde)
                  : std::string(26, ' ');
    fmt::print("{:30} {:15} {:9.2g} {:5} {} {}\n", scene, algorithm, agreement.pValue,
               agreement.tileSize, scale, verdict);
    std::fflush(stdout);
    return verdict == "alike" || verdict.find("within") != std::string::npos;
}

ExitCode verify(const fs::path &scenes, const fs::path &out, const std::vector<SceneFile> &chosen,
                int width, const std::atomic<bool> &interrupted) {
    const Sandbox sandbox;
    const TemporaryFolder temporary;
    // Bonferroni over the halves and two algorithms of each scene, whatever part is looked at.
    const double level = kFamilyLevel / (3.0 * static_cast<double>(readSceneFiles(scenes).size()));
    fmt::print(
        "Tile tests at a level of {:.2g} each ({:g} of all); scale in percent: estimate, "
        "upper bound (1e-4), minimal detectable\n\n{:30} {:15} {:>9} {:>5} {:>8} {:>8} {:>8}\n",
        level, kFamilyLevel, "scene", "against", "p", "tile", "scale", "bound", "mde");
    bool allRight = true;
    for (const SceneFile &scene : chosen) {
        const std::vector<ReferenceImage> plan = planReference(scene, width);
        std::array<protocol::Image, 2> halves;
        for (std::size_t i = 0; i < halves.size(); ++i) {
            halves[i] = readImage(sandbox, out / plan[i].file);
        }
        allRight = print(scene.name, "other half", compareHalves(halves), level, false) && allRight;
        for (const std::string &algorithm : independentAlgorithms(scene)) {
            const fs::path file = temporary.path() / "render.exr";
            const RenderJob job{scenes / scene.name,
                                algorithm,
                                plan[0].samplesPerPixel,
                                seedOf(fmt::format("{} of {}", algorithm, scene.name)),
                                halves[0].width,
                                halves[0].height,
                                file};
            if (runRenderer(job, interrupted) == RenderEnd::Interrupted)
                return ExitCode::Interrupted;
            const Agreement agreement =
                compareWithReference(readImage(sandbox, file), halves, level);
            allRight = print(scene.name, algorithm, agreement, level, true) && allRight;
        }
    }
    return allRight ? ExitCode::Done : ExitCode::CheckFailed;
}

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
        return verify(scenes, out, chosen, width, interrupted);
    std::vector<ReferenceImage> plan;
    for (const SceneFile &scene : chosen) {
        for (ReferenceImage &image : planReference(scene, width))
            plan.push_back(std::move(image));
    }
    return render(scenes, out, plan, interrupted);
}

} // namespace grader
