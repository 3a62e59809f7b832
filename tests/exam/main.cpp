// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <iostream>
#include <mutex>
#include <string_view>
#include <thread>

#include "grading.h"
#include "hand_in.h"
#include "machine.h"
#include "measurement.h"
#include "progress.h"
#include "run_options.h"
#include "stability.h"
#include "verdict_times.h"
#include "work_folder.h"

namespace {

namespace fs = std::filesystem;
using exam::Case;

struct Options {
    fs::path root;
    fs::path norigrade;
    std::string only;
    int seeds = 1;
    int jobs = 1;
};

/// One hand-in, graded with one seed.
struct Task {
    const Case *which = nullptr;
    int round = 0;
};

/// Prints a line per task as it ends, and on a terminal how long the rest will take.
class Table {
public:
    explicit Table(std::size_t tasks) : m_progress(tasks) {
        fmt::print("{:<42} {:<5} {:>6}  {}\n", "hand-in", "", "s", "expected -> got");
    }

    /// \param place  of the planted mistake among the diagnoses, 0 if it is not there
    void add(const Task &task, const std::string &got, double seconds,
             const std::vector<std::string> &misses, std::size_t place) {
        const std::lock_guard lock(m_mutex);
        m_planted += task.which->expectation.diagnosis.empty() ? 0 : 1;
        m_first += place == 1 ? 1 : 0;
        m_amongThree += place > 0 ? 1 : 0;
        m_progress.clear();
        const std::string name = task.round == 0
                                     ? task.which->name
                                     : fmt::format("{} #{}", task.which->name, task.round + 1);
        fmt::print("{:<42} {:<5} {:>6.1f}  {} -> {}\n", name, misses.empty() ? "ok" : "MISS",
                   seconds, exam::describe(task.which->expectation), got);
        for (const std::string &miss : misses)
            fmt::print("    {}\n", miss);
        std::cout << std::flush;
        m_missed += misses.empty() ? 0 : 1;
        m_progress.add();
    }

    /// \return  whether every expectation was met
    bool finish() {
        m_progress.clear();
        const std::size_t done = m_progress.done();
        fmt::print("{} of {} as expected, in {:.0f} s\n", done - m_missed, done,
                   m_progress.seconds());
        if (m_planted > 0)
            fmt::print(
                "the planted mistake is the first diagnosis in {} of {}, among three in {}\n",
                m_first, m_planted, m_amongThree);
        return m_missed == 0;
    }

private:
    exam::Progress m_progress;
    std::size_t m_missed = 0;
    std::size_t m_planted = 0, m_first = 0, m_amongThree = 0;
    std::mutex m_mutex;
};

/// Leftovers of a hostile hand-in.
std::vector<std::string> lookOver(const Case &which, const exam::Snapshot &before,
                                  const fs::path &root, const fs::path &scratch) {
    std::vector<std::string> found;
    for (const std::string &process : exam::killLeftProcesses())
        found.push_back("a process was left: " + process);
    for (const std::string &difference : exam::differences(before, exam::takeSnapshot(root)))
        found.push_back(difference);
    for (const fs::path &file : exam::leftFiles(which.expectation.leftFiles, scratch))
        found.push_back(file.string() + " was left");
    return found;
}

void perform(const Options &options, const Task &task, int jobs, const fs::path &work,
             Table &table) {
    const Case &which = *task.which;
    const fs::path scratch =
        work / fmt::format("{}-{}", fs::path(which.name).filename().string(), task.round);
    std::vector<std::string> misses;
    std::string got = "nothing";
    double seconds = 0;
    std::size_t place = 0;
    try {
        fs::create_directories(scratch);
        const fs::path handIn = compose(options.root, which, options.norigrade, scratch);
        const exam::Snapshot before =
            which.expectation.hostile ? exam::takeSnapshot(options.root) : exam::Snapshot();
        const exam::Graded graded = exam::parseResults(exam::gradeToJson(
            options.norigrade, handIn, {exam::seedOf(task.round), ""}, jobs, scratch));
        got = describe(graded);
        seconds = graded.seconds;
        misses = compare(which.expectation, graded);
        if (!which.expectation.diagnosis.empty())
            place = diagnosisPlace(which.expectation, graded);
        if (which.expectation.hostile) {
            for (std::string &found : lookOver(which, before, options.root, scratch))
                misses.push_back(std::move(found));
        }
    } catch (const std::exception &error) {
        misses.emplace_back(error.what());
    }
    table.add(task, got, seconds, misses, place);
    std::error_code ignored;
    fs::remove_all(scratch, ignored);
}

bool runExam(const Options &options) {
    const std::vector<Case> cases = exam::findCases(options.root, options.only);
    std::vector<Task> tasks, hostile;
    for (const Case &which : cases) {
        const bool accepted = which.name.rfind("accepted/", 0) == 0;
        for (int round = 0; round < (accepted ? options.seeds : 1); ++round)
            (which.expectation.hostile ? hostile : tasks).push_back({&which, round});
    }
    const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    const exam::WorkFolder work;
    Table table(tasks.size() + hostile.size());
    exam::adoptOrphans();
    std::atomic<std::size_t> next = 0;
    std::vector<std::thread> threads;
    threads.reserve(static_cast<std::size_t>(options.jobs));
    for (int i = 0; i < options.jobs; ++i)
        threads.emplace_back([&] {
            for (std::size_t at = next++; at < tasks.size(); at = next++)
                perform(options, tasks[at], std::max(1, cores / options.jobs), work.path(), table);
        });
    for (std::thread &thread : threads)
        thread.join();
    // One after the other: what is left of one must not be taken for what another is doing.
    for (const Task &task : hostile)
        perform(options, task, cores, work.path(), table);
    return table.finish();
}

/// \return  the exit code
int hold(int argc, char **argv) {
    const std::string_view verb = argc > 1 ? argv[1] : "";
    if (verb == "mutants" || verb == "variants")
        return exam::measure(argc - 1, argv + 1);
    if (verb == "stability")
        return exam::measureStability(argc - 1, argv + 1);
    if (verb == "verdict-times")
        return exam::measureVerdictTimes(argc - 1, argv + 1);
    Options options;
    CLI::App app("Grades the hand-ins of tests/submissions and prints expected against got.\n"
                 "Exit code: 0 all as expected, 1 some not, 2 the exam could not be held.",
                 "exam");
    exam::addPlace(app, "--root", options.root);
    exam::addPlace(app, "--norigrade", options.norigrade);
    app.add_option("--seeds", options.seeds, "Grade accepted hand-ins with this many seeds")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--only", options.only, "Only hand-ins with this text in their name")
        ->option_text("TEXT");
    app.add_option("--jobs", options.jobs, "Hand-ins at the same time (hostile ones: one)")
        ->check(CLI::Range(1, 64))
        ->capture_default_str();
    if (const std::optional<int> code = exam::parseCommandLine(app, argc, argv))
        return *code;
    return runExam(options) ? 0 : 1;
}

} // namespace

int main(int argc, char **argv) {
    try {
        return hold(argc, argv);
    } catch (const std::exception &error) {
        std::fprintf(stderr, "exam: %s\n", error.what());
        return 2;
    }
}
