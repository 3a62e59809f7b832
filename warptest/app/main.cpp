// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <exception>

#include "command_line.h"
#include "graphics.h"
#include "run_tests.h"
#include "warp_list.h"

namespace {

std::vector<viewer::Subject> subjectsOf(const CommandLine &line) {
    std::vector<viewer::Subject> subjects;
    const auto add = [&subjects](std::vector<viewer::Subject> more) {
        std::move(more.begin(), more.end(), std::back_inserter(subjects));
    };
    if (!line.against.empty()) {
        add(submittedWarps(line.against));
    }
    if (line.against.empty() || line.window) {
        add(rendererWarps());
    }
    if (line.mistakes) {
        add(mistakenWarps());
    }
    return subjects;
}

ExitCode show(CommandLine line, const std::vector<viewer::Subject> &subjects) {
    for (std::size_t i = subjects.size(); i-- > 0;) {
        line.settings.warp = isNamed(subjects[i], line.warp) ? i : line.settings.warp;
    }
    try {
        showWarpWindow(line, subjects);
        return ExitCode::Pass;
    } catch (const std::runtime_error &error) {
        fmt::print(stderr, "warptest: {}.\n", error.what());
        return ExitCode::Usage;
    }
}

ExitCode run(const CommandLine &line) {
    const std::vector<viewer::Subject> subjects = subjectsOf(line);
    const bool isKnown = line.warp.empty() ||
                         std::any_of(subjects.begin(), subjects.end(), [&](const auto &subject) {
                             return isNamed(subject, line.warp);
                         });
    if (!isKnown) {
        fmt::print(stderr, "warptest: there is no warp \"{}\"\n", line.warp);
        return ExitCode::Usage;
    }
    return line.window ? show(line, subjects) : runTests(line, subjects);
}

} // namespace

int main(int argc, char **argv) {
    int exitCode = 0;
    const std::optional<CommandLine> line = parseCommandLine(argc, argv, exitCode);
    if (!line) {
        return exitCode;
    }
    try {
        return static_cast<int>(run(*line));
    } catch (const std::exception &error) {
        fmt::print(stderr, "warptest: {}\n", error.what());
        return static_cast<int>(ExitCode::Fail);
    }
}
