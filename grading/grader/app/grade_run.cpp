// SPDX-License-Identifier: MIT
#include "grade_run.h"

#include <grader/error.h>
#include <grader/report/html_page.h>
#include <grader/report/terminal_report.h>
#include <grader/results/results_json.h>
#include <grader/results/safe_text.h>
#include <grader/scoring/scoring.h>
#include <grader/text_file.h>

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <set>

#include "terminal.h"

namespace grader {

namespace {

const char *useName(FileRole role) {
    switch (role) {
    case FileRole::Source:
        return "source";
    case FileRole::Extra:
        return "extra";
    case FileRole::Header:
        return "header";
    case FileRole::Readme:
        return "readme";
    case FileRole::Figure:
        return "figure";
    case FileRole::Ignored:
        break;
    }
    return "ignored";
}

std::string nameOf(const std::filesystem::path &path) {
    std::filesystem::path name = path.lexically_normal();
    if (!name.has_filename())
        name = name.parent_path();
    return name.extension() == ".zip" ? name.stem().string() : name.filename().string();
}

class Session {
public:
    Session(const GradeRun &run, const GradeFunction &grade)
        : m_run(run),
          m_grade(grade),
          m_style(terminalStyle(STDOUT_FILENO)),
          m_progress(!run.command.quiet) {
        m_result.provenance = run.provenance;
        m_style.language = run.command.language;
    }

    ExitCode gradeAll() {
        const std::vector<std::filesystem::path> &paths = m_run.command.paths;
        save(); // a folder that cannot be written is found before the work, not after it
        for (std::size_t i = 0; i < paths.size(); ++i) {
            m_what = fmt::format("{}/{} {}", i + 1, paths.size(), nameOf(paths[i]));
            if (m_run.interrupted)
                return stop(i);
            try {
                m_result.submissions.push_back(gradeOne(paths[i]));
            } catch (const Interrupted &) {
                return stop(i);
            }
            m_progress.clear();
            show(m_result.submissions.back());
            save();
        }
        finish();
        return exitCodeOf(m_result.submissions);
    }

private:
    SubmissionResult gradeOne(const std::filesystem::path &path) {
        const auto start = std::chrono::steady_clock::now();
        const auto seconds = [&] {
            return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        };
        Submission submission;
        submission.name = nameOf(path);
        m_progress.update(m_what, "reading", 0);
        Verdict blame = Verdict::Human;
        SubmissionResult result;
        double ingest = 0;
        try {
            submission = readSubmission(path);
            ingest = seconds();
            blame = Verdict::Infra;
            result = m_grade(submission, [this](std::string_view phase, double fraction) {
                m_progress.update(m_what, phase, fraction);
            });
        } catch (const GraderError &error) {
            result = untested(submission, blame, error.what());
        }
        result.marked = m_run.command.marked;
        result.hintSteps = m_run.rubric.hintSteps;
        for (const SubmittedFile &file : submission.files)
            result.files.push_back({file.path, useName(file.role), file.reason});
        result.timing.ingest = ingest;
        result.timing.total = seconds();
        return result;
    }

    SubmissionResult untested(const Submission &submission, Verdict blame,
                              const std::string &why) const {
        SubmissionResult result;
        result.name = submission.name;
        result.members = submission.members;
        result.sandbox = m_run.sandbox;
        result.seed = m_run.command.seed;
        result.notes = submission.notes;
        if (blame == Verdict::Human)
            result.notes.push_back({Note::Level::Human, "", "It cannot be read: " + why});
        const std::string reason = blame == Verdict::Human
                                       ? "Not graded: the hand-in cannot be read."
                                       : "Not graded, through no fault of the hand-in: " + why;
        scoreUntested(m_run.rubric, blame, reason, result);
        return result;
    }

    /// Takes a page name that no other hand-in of this run has.
    std::string newPageName(const std::string &name) {
        for (std::size_t before = 0;; ++before) {
            std::string page = pageName(name, before);
            if (m_pages.insert(page).second)
                return page;
        }
    }

    void save() {
        const std::filesystem::path &folder = m_run.command.out;
        if (folder.empty())
            return;
        std::error_code error;
        std::filesystem::create_directories(folder, error);
        if (error)
            throw GraderError(
                fmt::format("{}: cannot make this folder: {}", folder.string(), error.message()));
        const std::filesystem::path file = folder / "results.json";
        if (!m_saved && std::filesystem::exists(file))
            complain(fmt::format("{} is from an earlier run and is replaced", file.string()));
        m_saved = true;
        if (!m_result.submissions.empty()) {
            const SubmissionResult &last = m_result.submissions.back();
            writeTextFile(folder / newPageName(last.name),
                          htmlPage(last, m_result.provenance, m_run.command.language));
        }
        writeTextFile(file, resultsJson(m_result));
    }

    void show(const SubmissionResult &result) {
        if (m_run.command.json)
            return;
        if (m_run.command.quiet)
            fmt::print("{}: {}\n", safeLine(result.name), sumLine(result));
        else
            fmt::print("{}\n", terminalReport(result, m_style));
        std::fflush(stdout);
    }

    void finish() {
        const GradeCommand &command = m_run.command;
        if (command.json)
            fmt::print("{}", resultsJson(m_result));
        else if (!command.quiet && m_result.submissions.size() > 1) {
            for (const SubmissionResult &result : m_result.submissions)
                fmt::print("{}: {}\n", safeLine(result.name), sumLine(result));
        }
        std::fflush(stdout);
        for (const SubmissionResult &result : m_result.submissions) {
            if (hasInfraFailure(result))
                complain(result.name + ": a part could not be tested; grade it again");
            else if (needsHuman(result))
                complain(result.name + ": someone has to look");
        }
        if (command.quiet)
            return;
        const std::string where =
            command.out.empty() ? "" : (command.out / "results.json").string() + ", ";
        fmt::print(stderr, "{}seed {}\n", safeLine(where), command.seed);
    }

    ExitCode stop(std::size_t done) {
        m_progress.clear();
        const GradeCommand &command = m_run.command;
        if (command.json)
            fmt::print("{}", resultsJson(m_result));
        complain(fmt::format(
            "interrupted: {} of {} done{}", done, command.paths.size(),
            command.out.empty() ? "" : ", in " + (command.out / "results.json").string()));
        return ExitCode::Interrupted;
    }

    const GradeRun &m_run;
    const GradeFunction &m_grade;
    TerminalStyle m_style;
    ProgressLine m_progress;
    RunResult m_result;
    std::string m_what; ///< for the progress line
    std::set<std::string> m_pages;
    bool m_saved = false;
};

/// True if a test of what was asked for found something; an extra that is absent is no failure.
bool hasFailed(const ItemResult &item) {
    switch (item.verdict) {
    case Verdict::Fail:
    case Verdict::BuildError:
    case Verdict::Crash:
    case Verdict::Timeout:
        return true;
    case Verdict::Missing:
        return !item.extra;
    default:
        return false;
    }
}

} // namespace

ExitCode exitCodeOf(const std::vector<SubmissionResult> &results) {
    if (std::any_of(results.begin(), results.end(), hasInfraFailure))
        return ExitCode::Infra;
    if (std::any_of(results.begin(), results.end(), needsHuman))
        return ExitCode::NeedsHuman;
    const bool failed =
        std::any_of(results.begin(), results.end(), [](const SubmissionResult &result) {
            return !result.marked &&
                   std::any_of(result.items.begin(), result.items.end(), hasFailed);
        });
    return failed ? ExitCode::CheckFailed : ExitCode::Done;
}

ExitCode gradeAll(const GradeRun &run, const GradeFunction &grade) {
    return Session(run, grade).gradeAll();
}

} // namespace grader
