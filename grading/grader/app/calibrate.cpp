// SPDX-License-Identifier: MIT
#include <grader/app/frozen_rubric.h>
#include <grader/app/interrupt.h>
#include <grader/app/load_rubric.h>
#include <grader/app/provenance.h>
#include <grader/app/terminal.h>
#include <grader/app/verbs.h>
#include <grader/build/base.h>
#include <grader/build/cache.h>
#include <grader/calibration/corpus.h>
#include <grader/calibration/false_alarms.h>
#include <grader/calibration/judgement.h>
#include <grader/calibration/measurements.h>
#include <grader/digest.h>
#include <grader/engine/engine.h>
#include <grader/engine/engine_digest.h>
#include <grader/error.h>
#include <grader/results/safe_text.h>
#include <grader/scoring/points.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>

namespace grader {

namespace {

namespace fs = std::filesystem;

/// The same in every call, so that what was measured can be used again.
std::string seedOf(int round) {
    return fmt::format("{:032x}", 0xca11b0 + round);
}

/// A folder that goes at the end.
class WorkFolder {
public:
    WorkFolder() {
        std::string name = (fs::temp_directory_path() / "norigrade-calibrate-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            throw GraderError(name + ": cannot make this folder");
        m_path = name;
    }

    WorkFolder(const WorkFolder &) = delete;
    WorkFolder(WorkFolder &&) = delete;
    WorkFolder &operator=(const WorkFolder &) = delete;
    WorkFolder &operator=(WorkFolder &&) = delete;

    ~WorkFolder() {
        std::error_code ignored;
        fs::remove_all(m_path, ignored);
    }

    const fs::path &path() const { return m_path; }

private:
    fs::path m_path;
};

/// Measures hand-ins, or remembers what was measured of them.
class Measurer {
public:
    Measurer(const CalibrateCommand &command, const Rubric &rubric, const Sandbox &sandbox,
             const std::atomic<bool> &interrupted)
        : m_command(command),
          m_rubric(rubric),
          m_sandbox(sandbox),
          m_interrupted(interrupted),
          m_measures(engineDigest(sandbox.level())) {
        for (const RubricItem &item : rubric.items) {
            for (const RubricCheck &check : item.checks)
                m_measures += "|" + check.id;
        }
    }

    std::vector<CheckResult> measure(const CorpusCase &which, int round,
                                     const ProgressCallback &progress) {
        const WorkFolder work;
        const fs::path folder = work.path() / "hand-in";
        composeCase(which, folder);
        const Submission submission = readSubmission(folder);
        const std::string digest =
            sha256Hex(m_measures + "|" + submission.digest + "|" + seedOf(round));
        const fs::path file = m_cache.entry("calibrations", digest, ".json");
        if (auto known = readMeasurements(file))
            return *known;
        Engine engine(m_sandbox, {.seedHex = seedOf(round),
                                  .jobs = m_command.jobs,
                                  .rubric = &m_rubric,
                                  .asked = &m_rubric,
                                  .interrupted = &m_interrupted});
        std::vector<CheckResult> outcomes;
        for (const ItemResult &item : engine.grade(submission, progress).items)
            outcomes.insert(outcomes.end(), item.checks.begin(), item.checks.end());
        const bool ours = std::any_of(outcomes.begin(), outcomes.end(), [](const auto &check) {
            return check.verdict == Verdict::Infra;
        });
        if (!ours)
            writeMeasurements(file, outcomes);
        ++m_measured;
        return outcomes;
    }

    std::size_t measured() const { return m_measured; }

private:
    const CalibrateCommand &m_command;
    const Rubric &m_rubric;
    const Sandbox &m_sandbox;
    const std::atomic<bool> &m_interrupted;
    std::string m_measures; ///< the engine and the checks: another one measures anew
    Cache m_cache;
    std::size_t m_measured = 0;
};

void printBound(const Rubric &rubric, int classSize) {
    const fs::path levels = projectFolder() / "grading/grader/calibration/stage_levels.toml";
    fmt::print("{}",
               describeBound(composeBound(rubric, checkTable(), readStageLevels(levels), classSize),
                             classSize));
}

/// Items that no hand-in of the corpus can lose: nothing is known of them.
std::vector<std::string> untriedItems(const Rubric &rubric, const std::vector<CorpusCase> &cases) {
    std::vector<std::string> items;
    for (const RubricItem &item : rubric.items) {
        const bool tried = std::any_of(cases.begin(), cases.end(), [&](const CorpusCase &each) {
            return std::find(each.lost.begin(), each.lost.end(), item.id) != each.lost.end();
        });
        if (!tried)
            items.push_back(item.id);
    }
    return items;
}

/// Wrong hand-ins whose mistake is in no item of the rubric say nothing of it.
void dropForeign(const Rubric &rubric, std::vector<CorpusCase> &cases) {
    const auto isKnown = [&](const std::string &id) {
        return std::any_of(rubric.items.begin(), rubric.items.end(),
                           [&](const RubricItem &item) { return item.id == id; });
    };
    cases.erase(std::remove_if(cases.begin(), cases.end(),
                               [&](const CorpusCase &each) {
                                   return !each.lost.empty() &&
                                          std::none_of(each.lost.begin(), each.lost.end(), isKnown);
                               }),
                cases.end());
}

/// What the hand-ins that were tried cannot tell of a rubric, a sentence each.
std::vector<std::string> gapsOf(const Rubric &rubric, const std::vector<CorpusCase> &cases) {
    std::vector<std::string> gaps;
    for (const std::string &item : untriedItems(rubric, cases))
        gaps.push_back(item + ": no hand-in with a mistake in it was tried");
    if (std::none_of(cases.begin(), cases.end(),
                     [](const CorpusCase &each) { return each.isRight(); }))
        gaps.emplace_back("no hand-in was tried that is right");
    if (std::none_of(cases.begin(), cases.end(),
                     [](const CorpusCase &each) { return each.isStarter; }))
        gaps.emplace_back("what is handed out was not tried");
    return gaps;
}

/// So that a corpus that is not as it must be is told before the first grading.
/// \throws GraderError  if one cannot be put together
void composeAll(const std::vector<CorpusCase> &cases) {
    for (const CorpusCase &each : cases) {
        try {
            composeCase(each, WorkFolder().path() / "hand-in");
        } catch (const fs::filesystem_error &error) {
            throw GraderError(each.name + ": " + error.what());
        }
    }
}

ExitCode finish(const CalibrateCommand &command, const Rubric &rubric,
                const std::vector<CorpusCase> &cases, std::size_t wrong) {
    printBound(rubric, command.classSize);
    const std::vector<std::string> gaps = gapsOf(rubric, cases);
    for (const std::string &gap : gaps)
        fmt::print("{}\n", gap);
    fmt::print("{} of {} hand-ins are told apart as they must be\n", cases.size() - wrong,
               cases.size());
    if (!command.only.empty())
        fmt::print(
            "only those with \"{}\" in their name were tried: of the others nothing is said\n",
            command.only);
    if (wrong > 0 || (command.freeze && !gaps.empty())) {
        if (command.freeze)
            complain("not frozen: " +
                     (wrong > 0 ? "the rubric does not tell all hand-ins apart" : gaps.front()));
        return ExitCode::CheckFailed;
    }
    if (command.freeze) {
        freezeRubric(command.rubric, provenanceOf(rubric), cases.size(), command.seeds);
        fmt::print("{}: written\n", frozenFile(command.rubric).string());
    }
    return ExitCode::Done;
}

ExitCode calibrate(const CalibrateCommand &command, const Rubric &rubric,
                   const std::vector<CorpusCase> &cases) {
    const std::atomic<bool> &interrupted = catchInterrupts();
    const Sandbox sandbox;
    Measurer measurer(command, rubric, sandbox, interrupted);
    ProgressLine progress(true);
    const auto start = std::chrono::steady_clock::now();
    std::size_t wrong = 0;
    std::size_t measuredCases = 0; // the others were known: they take no time
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const CorpusCase &which = cases[i];
        std::vector<std::string> findings;
        const std::size_t before = measurer.measured();
        for (int round = 0; round < command.seeds && findings.empty(); ++round) {
            const double minutes =
                std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() /
                60;
            const std::string left =
                measuredCases > 0 ? fmt::format(", about {:.0f} min left",
                                                minutes / static_cast<double>(measuredCases) *
                                                    static_cast<double>(cases.size() - i))
                                  : "";
            const std::string what =
                fmt::format("{}/{}{} {}", i + 1, cases.size(), left, which.name);
            try {
                const std::vector<CheckResult> outcomes =
                    measurer.measure(which, round, [&](std::string_view phase, double fraction) {
                        progress.update(what, phase, fraction);
                    });
                findings = judgeCase(rubric, which, outcomes);
            } catch (const Interrupted &) {
                progress.clear();
                complain(fmt::format("interrupted: {} of {} done; what was measured is kept, a "
                                     "second call goes on",
                                     i, cases.size()));
                return ExitCode::Interrupted;
            }
        }
        progress.clear();
        measuredCases += measurer.measured() > before ? 1 : 0;
        wrong += findings.empty() ? 0 : 1;
        fmt::print("{} {}\n", findings.empty() ? "ok  " : "MISS", safeLine(which.name));
        for (const std::string &finding : findings)
            fmt::print("       {}\n", safeLine(finding));
        std::fflush(stdout);
    }
    return finish(command, rubric, cases, wrong);
}

} // namespace

ExitCode run(const CalibrateCommand &command) {
    Rubric rubric;
    std::vector<CorpusCase> cases;
    try {
        rubric = loadRubric(command.rubric);
        if (command.boundOnly) {
            printBound(rubric, command.classSize);
            return ExitCode::Done;
        }
        cases = readCorpus(command.corpus.empty() ? projectFolder() / "tests" : command.corpus,
                           command.only);
        dropForeign(rubric, cases);
        composeAll(cases);
    } catch (const GraderError &error) {
        return run(UsageMistake{error.what()});
    }
    try {
        return calibrate(command, rubric, cases);
    } catch (const SandboxTooWeak &error) {
        complain(error.what());
        return ExitCode::SandboxTooLow;
    }
}

} // namespace grader
