// SPDX-License-Identifier: MIT
#include <grader/app/frozen_rubric.h>
#include <grader/app/grade_run.h>
#include <grader/app/interrupt.h>
#include <grader/app/load_rubric.h>
#include <grader/app/provenance.h>
#include <grader/app/terminal.h>
#include <grader/app/verbs.h>
#include <grader/build/base.h>
#include <grader/engine/engine.h>
#include <grader/error.h>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>

namespace grader {

namespace {

/// A folder that was not there before, named by the time in UTC.
std::filesystem::path newResultsFolder() {
    const std::string time = fmt::format("{:%Y%m%dT%H%M%SZ}", fmt::gmtime(std::time(nullptr)));
    const std::filesystem::path folder = std::filesystem::path("norigrade-results") / time;
    std::filesystem::path free = folder;
    for (int i = 2; std::filesystem::exists(free); ++i)
        free = fmt::format("{}-{}", folder.string(), i);
    return free;
}

/// What is wrong with the paths, before any work is done; empty if nothing is.
std::string pathMistake(const GradeCommand &command) {
    for (const std::filesystem::path &path : command.paths) {
        std::error_code error;
        if (!std::filesystem::exists(path, error))
            return fmt::format("{}: no such file or folder", path.string());
    }
    if (std::filesystem::exists(command.out) && !std::filesystem::is_directory(command.out))
        return fmt::format("--out {}: this is a file, a folder is needed", command.out.string());
    return {};
}

FigureScenes scenesOf(const GradeCommand &command) {
    if (!command.scenes.empty())
        return {command.scenes, true};
    return {projectFolder() / "scenes" / "assignment-2", false};
}

/// \param asked  the items of the rubric that are asked for; figures are compared with all of them
ExitCode gradeWith(const GradeCommand &command, const Rubric &rubric, const Rubric &asked,
                   const FigureScenes &scenes) {
    const std::atomic<bool> &interrupted = catchInterrupts();
    const Sandbox sandbox;
    Engine engine(sandbox, {.seedHex = command.seed,
                            .jobs = command.jobs,
                            .rubric = &rubric,
                            .asked = &asked,
                            .scenes = command.items.empty() ? &scenes : nullptr,
                            .interrupted = &interrupted});
    const Provenance provenance = provenanceOf(rubric);
    if (const std::string stamp = describeFrozen(command.rubric, provenance);
        !stamp.empty() && !command.quiet)
        complain(stamp);
    const GradeRun run{command, asked, provenance, interrupted, sandboxLevelName(sandbox.level())};
    return gradeAll(run, [&](const Submission &submission, const ProgressCallback &progress) {
        return engine.grade(submission, progress);
    });
}

} // namespace

ExitCode run(const GradeCommand &command) {
    if (const std::string mistake = pathMistake(command); !mistake.empty())
        return run(UsageMistake{mistake});
    Rubric rubric;
    Rubric asked;
    FigureScenes scenes;
    try {
        rubric = loadRubric(command.rubric);
        asked = withItems(rubric, command.items);
        scenes = scenesOf(command);
    } catch (const GraderError &error) {
        return run(UsageMistake{error.what()});
    }
    GradeCommand decided = command;
    if (decided.seed.empty())
        decided.seed = freshSeed();
    if (decided.out.empty() && decided.marked)
        decided.out = newResultsFolder();
    try {
        return gradeWith(decided, rubric, asked, scenes);
    } catch (const SandboxTooWeak &error) {
        complain(error.what());
        return ExitCode::SandboxTooLow;
    }
}

} // namespace grader
