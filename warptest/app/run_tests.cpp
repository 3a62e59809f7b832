// SPDX-License-Identifier: MIT
#include "run_tests.h"

#include <grader/app/terminal.h>

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "dump.h"
#include "graphics.h"
#include "page.h"
#include <viewer/battery_report.h>
#include <viewer/report_json.h>

namespace {

using battery::Status;

/// One test of the run.
struct Task {
    const viewer::Subject *subject = nullptr;
    viewer::Settings settings;
    bool isShown = false; ///< at the parameter that the handout's picture is of
};

/// \return  the worst of the verdicts so far
ExitCode worse(ExitCode code, Status verdict) {
    if (verdict == Status::Fail || code == ExitCode::Fail) {
        return ExitCode::Fail;
    }
    return verdict == Status::Pass ? code : ExitCode::Inconclusive;
}

std::vector<Task> plan(const CommandLine &line, const std::vector<viewer::Subject> &subjects) {
    std::vector<Task> tasks;
    for (std::size_t i = 0; i < subjects.size(); ++i) {
        const viewer::Subject &subject = subjects[i];
        if (!line.all && !isNamed(subject, line.warp)) {
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
        for (const double a : parameters) {
            Task task{&subject, line.settings, a == shown};
            task.settings.warp = i;
            task.settings.parameter = a;
            tasks.push_back(task);
        }
    }
    return tasks;
}

/// One test with its maps, as the window runs it.
viewer::TestReport test(const Task &task, const std::function<void(double)> &progress) {
    const viewer::TestControl control{progress, [] {
                                          return false;
                                      }};
    viewer::TestReport report = viewer::runBattery(*task.subject, task.settings, control);
    if (report.result.error.empty()) {
        report.maps = viewer::drawMaps(*task.subject, task.settings);
    }
    return report;
}

/// A hand-in need not hold what the handout does not ask for.
bool isLeftOut(const CommandLine &line, const viewer::Subject &subject,
               const battery::TestResult &result) {
    return line.all && !line.against.empty() && subject.truth->rubricId.empty() && result.isStub;
}

/// "10 of 11 tests pass; not tent": what has scrolled away.
std::string summary(const std::vector<viewer::Tested> &tests) {
    std::string others;
    std::size_t passed = 0;
    for (const viewer::Tested &test : tests) {
        if (test.report.result.passed()) {
            ++passed;
        } else {
            others +=
                (others.empty() ? "; not " : ", ") + viewer::title(*test.subject, test.report);
        }
    }
    return fmt::format("{} of {} tests pass{}", passed, tests.size(), others);
}

} // namespace

ExitCode runTests(const CommandLine &line, const std::vector<viewer::Subject> &subjects) {
    const std::vector<Task> tasks = plan(line, subjects);
    grader::ProgressLine progress(true);
    ExitCode code = ExitCode::Pass;
    std::vector<viewer::Tested> tests;
    for (std::size_t i = 0; i < tasks.size(); ++i) {
        const Task &task = tasks[i];
        const std::string what = fmt::format("{}/{} {}", i + 1, tasks.size(), task.subject->name);
        tests.push_back({task.subject,
                         test(task, [&](double done) { progress.update(what, "testing", done); })});
        progress.clear();
        const viewer::TestReport &report = tests.back().report;
        if (isLeftOut(line, *task.subject, report.result)) {
            fmt::print(stderr, "{}: not implemented, and the handout does not ask for it\n",
                       task.subject->name);
            tests.pop_back();
            continue;
        }
        code = worse(code, report.result.verdict);
        if (!line.json && line.dump == DumpFormat::None) {
            fmt::print("{}  {}", viewer::title(*task.subject, report),
                       battery::explain(report.result));
        }
        if (!line.evidence.empty() && task.isShown) {
            fmt::print(stderr, "saved {}\n", saveEvidence(*task.subject, report, line.evidence));
        }
    }
    if (line.all && !line.json && line.dump == DumpFormat::None) {
        fmt::print("{}\n", summary(tests));
    }
    if (!line.html.empty()) {
        writePage(line, tests);
        fmt::print(stderr, "saved {}\n", line.html);
    }
    if (line.json) {
        fmt::print("{}", viewer::documentJson(tests));
    }
    if (line.dump != DumpFormat::None) {
        fmt::print("{}", dumpText(line.dump, tests));
    }
    return code;
}
