// SPDX-License-Identifier: MIT
//
// `./run attack`: runs every attacker of the table and every hostile archive at both levels and
// prints what was seen. Exits with 1 if one has gained or left something.
#include <grader/error.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <sstream>

#include "attack_report.h"
#include <exam/summary.h>

namespace {

using attack::Attack;
using attack::Judge;
using attack::Kind;
using attack::ReportRow;
using attack::Seen;
using grader::SandboxLevel;
using grader::test::HostileArchive;

constexpr int kNotHeld = 4;  ///< exit code
constexpr int kSkipped = 77; ///< for CTest

struct Options {
    std::string level; ///< empty: both
    bool quick = false;
    std::vector<std::string> names;
    std::string record;
    std::string commit;
};

bool isQuick(const Attack &attack) {
    return attack.kind != Kind::Hostile && attack.kind != Kind::Source &&
           attack.kind != Kind::HandIn && attack.group != 'E';
}

/// One row of the report, and how it is filled.
struct Task {
    ReportRow row;
    SandboxLevel weakest = SandboxLevel::S2;
    std::function<Seen(Judge &)> run;
};

std::vector<Task> tasksFor(const Options &options) {
    std::vector<Task> tasks;
    const auto add = [&](Task task) {
        if (options.names.empty() ||
            std::count(options.names.begin(), options.names.end(), task.row.name) > 0)
            tasks.push_back(std::move(task));
    };
    for (const Attack &attack : attack::attackTable()) {
        if (options.quick && !isQuick(attack))
            continue;
        const bool atCompileTime = attack.kind == Kind::Source || attack.group == 'C';
        add({{std::string(1, attack.group), attack.name, attack.tries, atCompileTime, {}},
             attack.contained,
             [&attack](Judge &judge) {
                 return judge.run(attack);
             }});
    }
    using Table = std::vector<HostileArchive>;
    const std::pair<const char *, Table> archives[] = {
        {"a path that leads elsewhere or hides something", grader::test::hostilePaths()},
        {"an entry that is no plain file, or two of one name", grader::test::hostileEntries()},
        {"more than is allowed", grader::test::hostileSizes()},
        {"cut, changed, contradicting itself, of another kind", grader::test::brokenArchives()}};
    for (const auto &[tries, table] : archives) {
        for (const HostileArchive &archive : options.quick ? Table() : table)
            add({{"archive", archive.name, tries, false, {}},
                 SandboxLevel::S2,
                 [archive](Judge &judge) {
                     return judge.run(archive);
                 }});
    }
    return tasks;
}

/// On a terminal, how far it is.
class Progress {
public:
    Progress(SandboxLevel level, std::size_t count)
        : m_level(level), m_count(count), m_terminal(::isatty(2) != 0) {}

    void next() {
        ++m_done;
        const std::chrono::duration<double> past = std::chrono::steady_clock::now() - m_start;
        if (m_terminal)
            fmt::print(stderr, "\r{}: {} of {}, {:.0f} s left   \r", sandboxLevelName(m_level),
                       m_done, m_count,
                       past.count() / static_cast<double>(m_done) *
                           static_cast<double>(m_count - m_done));
    }

private:
    SandboxLevel m_level;
    std::size_t m_count;
    std::size_t m_done = 0;
    bool m_terminal;
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

void runAll(SandboxLevel level, const Options &options, std::vector<Task> &tasks) {
    Judge judge(level, options.quick);
    if (judge.level() != level)
        throw std::runtime_error(
            fmt::format("this machine gives {}, not {}; see `norigrade doctor`",
                        sandboxLevelName(judge.level()), sandboxLevelName(level)));
    if (!judge.honestPasses())
        throw std::runtime_error("the honest program does not pass the checks");
    Progress progress(level, tasks.size());
    for (Task &task : tasks) {
        if (level < task.weakest)
            continue;
        const Seen seen = task.run(judge);
        fmt::print("{} {:<7} {:<29} {:<51} {} {}\n", sandboxLevelName(level), task.row.group,
                   task.row.name, task.row.tries,
                   seen.contained ? "contained:" : "NOT CONTAINED:", seen.what);
        std::fflush(stdout);
        task.row.seen[level] = seen;
        progress.next();
    }
}

/// A level is tried in a process of its own: on another core, and with traces that are its own.
class LevelRun {
public:
    LevelRun(SandboxLevel level, const Options &options, std::vector<Task> &tasks)
        : m_level(level) {
        int ends[2];
        if (::pipe2(ends, O_CLOEXEC) != 0 || (m_process = ::fork()) < 0)
            throw std::runtime_error("no process for a level");
        if (m_process == 0) {
            ::close(ends[0]);
            ::_exit(runHere(options, tasks, ends[1]));
        }
        ::close(ends[1]);
        m_report = ends[0];
    }

    /// Waits for its end, and takes over what it has seen.
    /// \return  its exit code, 0 or kNotHeld
    int finish(std::vector<Task> &tasks) const {
        std::string report;
        char block[4096];
        for (ssize_t count = 0; (count = ::read(m_report, block, sizeof block)) > 0;)
            report.append(block, static_cast<std::size_t>(count));
        ::close(m_report);
        int status = 0;
        ::waitpid(m_process, &status, 0);
        std::istringstream lines(report);
        for (Task &task : tasks) {
            Seen seen;
            if (m_level >= task.weakest && attack::readSeen(lines, seen))
                task.row.seen[m_level] = seen;
        }
        return WIFEXITED(status) ? WEXITSTATUS(status) : kNotHeld;
    }

private:
    int runHere(const Options &options, std::vector<Task> &tasks, int report) const {
        try {
            runAll(m_level, options, tasks);
        } catch (const std::exception &error) {
            fmt::print(stderr, "attack: {}\n", error.what());
            return kNotHeld;
        }
        std::ostringstream lines;
        for (const Task &task : tasks) {
            if (const auto seen = task.row.seen.find(m_level); seen != task.row.seen.end())
                attack::writeSeen(lines, seen->second);
        }
        const std::string text = lines.str();
        const auto written = ::write(report, text.data(), text.size());
        return written == static_cast<ssize_t>(text.size()) ? 0 : kNotHeld;
    }

    SandboxLevel m_level;
    pid_t m_process = -1;
    int m_report = -1;
};

int run(const Options &options) {
    std::vector<Task> tasks = tasksFor(options);
    if (tasks.empty()) {
        fmt::print(stderr, "attack: there is no attacker of that name\n");
        return 2;
    }
    std::vector<SandboxLevel> levels;
    std::vector<LevelRun> runs;
    for (const SandboxLevel level : {SandboxLevel::S3, SandboxLevel::S2}) {
        if (!options.level.empty() && options.level != sandboxLevelName(level))
            continue;
        levels.push_back(level);
        runs.emplace_back(level, options, tasks);
    }
    bool held = true;
    for (const LevelRun &each : runs)
        held = each.finish(tasks) == 0 && held;
    if (!held)
        return kNotHeld;
    std::vector<ReportRow> rows;
    for (const Task &task : tasks)
        rows.push_back(task.row);
    for (const SandboxLevel level : levels)
        fmt::print("{}\n", attack::summarise(rows, level));
    if (!options.record.empty())
        exam::replaceSection(options.record, "attack", attack::markdown(rows, options.commit));
    const bool contained = std::all_of(rows.begin(), rows.end(), [](const ReportRow &row) {
        return std::all_of(row.seen.begin(), row.seen.end(),
                           [](const auto &seen) { return seen.second.contained; });
    });
    return contained ? 0 : 1;
}

} // namespace

int main(int argc, char **argv) {
    Options options;
    CLI::App app("Lets every attacker of tests/attackers and every hostile archive loose at both "
                 "levels of the sandbox.\nExit codes: 0 all contained, 1 not all, 2 usage, 4 the "
                 "machine does not give the level.",
                 "./run attack");
    app.add_option("--level", options.level, "Only this level")->check(CLI::IsMember({"S2", "S3"}));
    app.add_flag("--quick", options.quick, "Only what takes no second each; archives have a test");
    app.add_option("names", options.names, "Only these attackers");
    CLI::Option *record =
        app.add_option("--record", options.record, "Write the table into this Markdown file")
            ->option_text("FILE")
            ->excludes("--level", "--quick", "names");
    app.add_option("--commit", options.commit, "What is measured, for the table")->needs(record);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError &error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    try {
        const int code = run(options);
        // An ordinary user's machine often has no control groups; one that tests for all must.
        return code == kNotHeld && options.quick && std::getenv("CI") == nullptr ? kSkipped : code;
    } catch (const std::exception &error) {
        fmt::print(stderr, "attack: {}\n", error.what());
        return kNotHeld;
    }
}
