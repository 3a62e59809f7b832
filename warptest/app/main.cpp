// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <exception>
#include <iterator>

#include "command_line.h"
#include "graphics.h"
#include "warp_list.h"
#include <viewer/battery_report.h>
#include <viewer/report_json.h>

namespace {

using battery::Status;

constexpr int kFail = 1;
constexpr int kUsage = 2; ///< also: no window can be opened
constexpr int kInconclusive = 3;

/// \return  the worst of the verdicts so far
int worse(int code, Status verdict) {
    if (verdict == Status::Fail || code == kFail) {
        return kFail;
    }
    return verdict == Status::Pass ? code : kInconclusive;
}

void print(const viewer::Subject &subject, const viewer::TestReport &report) {
    const std::string parameter =
        subject.truth->hasParameter ? fmt::format(" α = {:.6g}", report.settings.parameter) : "";
    fmt::print("{}{}  {}", subject.name, parameter, battery::explain(report.result));
}

/// One test with its maps, as the window runs it.
viewer::TestReport test(const viewer::Subject &subject, const viewer::Settings &settings) {
    const viewer::TestControl control{[](double) {},
                                      [] {
                                          return false;
                                      }};
    viewer::TestReport report = viewer::runBattery(subject, settings, control);
    if (report.result.error.empty()) {
        report.maps = viewer::drawMaps(subject, settings);
    }
    report.settings = settings;
    return report;
}

int runTests(const CommandLine &line, const std::vector<viewer::Subject> &subjects) {
    int code = 0;
    std::vector<std::string> documents;
    for (std::size_t i = 0; i < subjects.size(); ++i) {
        const viewer::Subject &subject = subjects[i];
        if (!line.all && subject.name != line.warp) {
            continue;
        }
        const double shown = line.settings.parameter > 0.0
                                 ? line.settings.parameter
                                 : viewer::defaultParameter(*subject.truth);
        std::vector<double> parameters{shown};
        if (line.all) {
            const auto known = subject.truth->parameters;
            std::copy_if(known.begin(), known.end(), std::back_inserter(parameters),
                         [&](double a) { return a != shown; });
        }
        for (std::size_t p = 0; p < parameters.size(); ++p) {
            viewer::Settings settings = line.settings;
            settings.warp = i;
            settings.parameter = parameters[p];
            const viewer::TestReport report = test(subject, settings);
            code = worse(code, report.result.verdict);
            if (line.json) {
                documents.push_back(viewer::reportJson(subject, report));
            } else {
                print(subject, report);
            }
            if (!line.evidence.empty() && p == 0) { // the handout wants one picture of each
                const std::string file = saveEvidence(subject, report, line.evidence);
                fmt::print(stderr, "saved {}\n", file);
            }
        }
    }
    if (line.json) {
        fmt::print("{}", viewer::documentJson(documents));
    }
    return code;
}

int run(const CommandLine &line) {
    std::vector<viewer::Subject> subjects = rendererWarps();
    if (line.mistakes) {
        for (viewer::Subject &subject : mistakenWarps()) {
            subjects.push_back(std::move(subject));
        }
    }
    const auto named = std::find_if(subjects.begin(), subjects.end(),
                                    [&](const auto &subject) { return subject.name == line.warp; });
    if (named == subjects.end() && !line.warp.empty()) {
        fmt::print(stderr, "warptest: there is no warp \"{}\"\n", line.warp);
        return kUsage;
    }
    if (!line.window) {
        return runTests(line, subjects);
    }
    CommandLine shown = line;
    shown.settings.warp =
        named == subjects.end() ? 0 : static_cast<std::size_t>(named - subjects.begin());
    try {
        showWarpWindow(shown, subjects);
        return 0;
    } catch (const std::runtime_error &error) {
        fmt::print(stderr,
                   "warptest: {}. `warptest WARP` tests without a window, `--screenshot "
                   "FILE` draws one without a display.\n",
                   error.what());
        return kUsage;
    }
}

} // namespace

int main(int argc, char **argv) {
    int exitCode = 0;
    const std::optional<CommandLine> line = parseCommandLine(argc, argv, exitCode);
    if (!line) {
        return exitCode;
    }
    try {
        return run(*line);
    } catch (const std::exception &error) {
        fmt::print(stderr, "Error: {}\n", error.what());
        return kFail;
    }
}
