// SPDX-License-Identifier: MIT
#include "measurement.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <iostream>
#include <mutex>
#include <thread>

#include "command.h"
#include "result_cache.h"
#include "summary.h"
#include "work_folder.h"

namespace exam {

namespace {

namespace fs = std::filesystem;

constexpr int kInterrupted = 75;

std::atomic<bool> interrupted = false; // NOLINT: a signal can reach nothing else

struct Options {
    fs::path project;
    fs::path norigrade;
    fs::path cache;
    fs::path record; ///< Markdown file; empty: none
    std::string only;
    int whole = 1;
    int seeds = 0;
    int jobs = 1;
};

/// One grading of one patch.
struct Task {
    std::size_t patch = 0;
    bool ownItem = false; ///< or the whole hand-in
    int round = 0;        ///< seed
};

/// Works off all tasks on several threads, tells how long the rest will take, and keeps every
/// result, so that a run that was interrupted goes on where it was.
class Measurement {
public:
    Measurement(const Options &options, const std::string &verb)
        : m_options(options),
          m_patches(findPatches(options.project / "tests" / verb, options.only)),
          m_cache(options.cache,
                  {options.norigrade, options.project / "renderer",
                   options.project / "grading" / "probe", options.project / "grading" / "protocol",
                   options.project / "grading" / "rubrics", options.project / "scenes" / "grading",
                   options.project / "scenes" / "assignment-2" / "serapis"}),
          m_judgements(m_patches.size()),
          m_start(std::chrono::steady_clock::now()),
          m_terminal(isatty(STDERR_FILENO) != 0) {
        for (int round = 0; round < options.whole; ++round)
            addTasks(false, round);
        for (int round = 0; round < options.seeds; ++round)
            addTasks(true, options.whole + round);
    }

    void run() {
        std::vector<std::thread> threads;
        threads.reserve(static_cast<std::size_t>(m_options.jobs));
        for (int i = 0; i < m_options.jobs; ++i)
            threads.emplace_back([&] {
                for (std::size_t at = m_next++; at < m_tasks.size() && !interrupted; at = m_next++)
                    perform(m_tasks[at]);
            });
        for (std::thread &thread : threads)
            thread.join();
        clearProgress();
        if (!m_error.empty())
            throw ExamError(m_error);
    }

    std::vector<PatchRecord> records() const {
        std::vector<PatchRecord> records;
        for (std::size_t i = 0; i < m_patches.size(); ++i) {
            PatchRecord record{m_patches[i], {}, {}};
            for (const auto &[key, judgement] : m_judgements[i])
                (key.first ? record.item : record.whole).push_back(judgement);
            records.push_back(std::move(record));
        }
        return records;
    }

    std::size_t done() const { return m_done; }

    std::size_t tasks() const { return m_tasks.size(); }

private:
    void addTasks(bool ownItem, int round) {
        for (std::size_t i = 0; i < m_patches.size(); ++i) {
            if (!ownItem || !m_patches[i].item.empty())
                m_tasks.push_back({i, ownItem, round});
        }
    }

    void perform(const Task &task) {
        const Patch &patch = m_patches[task.patch];
        const fs::path scratch =
            m_work.path() / fmt::format("{}-{}-{}", task.patch, task.ownItem, task.round);
        try {
            fs::create_directories(scratch);
            const fs::path handIn =
                apply(patch, m_options.project / "tests" / "submissions", scratch);
            const Question question{seedOf(task.round), task.ownItem ? patch.item : ""};
            const std::string key = m_cache.key(handIn, question.seed + question.item);
            std::optional<std::string> json = m_cache.find(key);
            const bool isNew = !json;
            if (isNew) {
                json = gradeToJson(m_options.norigrade, handIn, question, 1, scratch);
                m_cache.store(key, *json);
            }
            add(task, judge(patch, parseResults(*json)), isNew);
        } catch (const std::exception &error) {
            const std::lock_guard lock(m_mutex);
            if (!interrupted)
                m_error = fmt::format("{}: {}", patch.name, error.what());
            interrupted = true;
        }
        std::error_code ignored;
        fs::remove_all(scratch, ignored);
    }

    void add(const Task &task, const Judgement &judgement, bool isNew) {
        const std::lock_guard lock(m_mutex);
        clearProgress();
        const Patch &patch = m_patches[task.patch];
        const std::string name =
            patch.name + (task.ownItem     ? fmt::format(" (item, seed {})", task.round)
                          : task.round > 0 ? fmt::format(" (seed {})", task.round)
                                           : "");
        const std::string diagnosis =
            patch.diagnoses.empty()
                ? ""
                : fmt::format("diagnosis {}", judgement.diagnosisRank == 0
                                                  ? "no"
                                                  : fmt::format("{}", judgement.diagnosisRank));
        fmt::print("{:<48} {:<5} {:<8} {:<12} {}\n", name, judgement.asExpected ? "ok" : "MISS",
                   patch.costName(), diagnosis, judgement.got);
        std::cout << std::flush;
        m_judgements[task.patch][{task.ownItem, task.round}] = judgement;
        ++m_done;
        m_new += isNew ? 1 : 0;
        showProgress();
    }

    void clearProgress() const {
        if (m_terminal)
            std::cerr << "\r\x1b[K" << std::flush;
    }

    void showProgress() const {
        if (!m_terminal || m_new == 0)
            return;
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
        const double left =
            seconds / static_cast<double>(m_new) * static_cast<double>(m_tasks.size() - m_done);
        std::cerr << fmt::format("{} of {}, {:.0f} min left", m_done, m_tasks.size(), left / 60)
                  << std::flush;
    }

    Options m_options;
    std::vector<Patch> m_patches;
    ResultCache m_cache;
    WorkFolder m_work;
    std::vector<Task> m_tasks;
    std::vector<std::map<std::pair<bool, int>, Judgement>> m_judgements; ///< by patch
    std::chrono::steady_clock::time_point m_start;
    bool m_terminal;
    std::atomic<std::size_t> m_next = 0;
    std::size_t m_done = 0, m_new = 0;
    std::string m_error;
    std::mutex m_mutex;
};

std::string commitOf(const fs::path &project) {
    const WorkFolder work;
    const Outcome outcome =
        runCommand({"git", "-C", project.string(), "describe", "--always", "--dirty"}, work.path());
    return outcome.output.substr(0, outcome.output.find('\n'));
}

} // namespace

int measure(int argc, char **argv) {
    const std::string verb = argv[0];
    const bool mutants = verb == "mutants";
    Options options;
    options.whole = mutants ? 1 : 5;
    options.seeds = mutants ? 4 : 0;
    options.jobs = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    CLI::App app(mutants ? "Grades every mutant: one mistake each, which has to cost its item, and "
                           "nothing else."
                         : "Grades every correct variant, which must lose nothing.",
                 "./run " + verb);
    app.add_option("--project", options.project, "The project's folder")->required();
    app.add_option("--norigrade", options.norigrade, "The program to examine")->required();
    app.add_option("--cache", options.cache, "Where results are kept")->required();
    app.add_option("--only", options.only, "Only those with this text in their name")
        ->option_text("TEXT");
    app.add_option("--whole", options.whole, "Gradings of each whole hand-in, a seed each")
        ->check(CLI::Range(0, 10'000))
        ->capture_default_str();
    if (mutants)
        app.add_option("--seeds", options.seeds, "Gradings of each one's own item, further seeds")
            ->check(CLI::Range(0, 10'000))
            ->capture_default_str();
    app.add_option("--jobs", options.jobs, "Gradings at the same time")
        ->check(CLI::Range(1, 64))
        ->capture_default_str();
    app.add_option("--record", options.record, "Write the table into this Markdown file")
        ->option_text("FILE");
    app.footer("Results are kept: a second call grades only what has changed.\n"
               "Exit codes: 0 all as expected, 1 some not, 2 usage, 75 interrupted.");
    CLI11_PARSE(app, argc, argv);

    for (const int signal : {SIGINT, SIGTERM})
        std::signal(signal, [](int) { interrupted = true; });
    Measurement measurement(options, verb);
    measurement.run();
    const std::vector<PatchRecord> records = measurement.records();
    fmt::print("\n{}", summarise(records));
    if (interrupted) {
        fmt::print(stderr, "interrupted: {} of {} gradings done; call again to go on\n",
                   measurement.done(), measurement.tasks());
        return kInterrupted;
    }
    if (!options.record.empty())
        replaceSection(options.record, verb, markdown(records, commitOf(options.project)));
    const bool right = std::all_of(records.begin(), records.end(),
                                   [](const PatchRecord &record) { return record.asExpected(); });
    return right ? 0 : 1;
}

} // namespace exam
