// SPDX-License-Identifier: MIT
#include "measurement.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <map>

#include "run_options.h"
#include "summary.h"

namespace exam {

namespace {

namespace fs = std::filesystem;

struct Options : RunOptions {
    int whole = 1;
    int seeds = 0;
};

/// One grading of one patch.
struct Task {
    std::size_t patch = 0;
    bool ownItem = false; ///< or the whole hand-in
    int round = 0;        ///< seed
};

/// Grades the patches and judges what comes of it.
class Measurement {
public:
    Measurement(const Options &options, const std::string &verb)
        : m_options(options),
          m_patches(findPatches(options.places.project / "tests" / verb, options.only)),
          m_judgements(m_patches.size()) {
        for (int round = 0; round < options.whole; ++round)
            addTasks(false, round);
        for (int round = 0; round < options.seeds; ++round)
            addTasks(true, options.whole + round);
    }

    void run() {
        GradingQueue queue(m_options.places, m_options.jobs);
        std::vector<GradingTask> gradings;
        for (const Task &task : m_tasks)
            gradings.push_back(gradingOf(task));
        m_done = queue.run(gradings, [this](std::size_t at, const std::string &json) {
            add(m_tasks[at], judge(m_patches[m_tasks[at].patch], parseResults(json)));
        });
        m_failures = queue.failures();
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

    const Failures &failures() const { return m_failures; }

    std::size_t tasks() const { return m_tasks.size(); }

private:
    void addTasks(bool ownItem, int round) {
        for (std::size_t i = 0; i < m_patches.size(); ++i) {
            if (!ownItem || !m_patches[i].item.empty())
                m_tasks.push_back({i, ownItem, round});
        }
    }

    GradingTask gradingOf(const Task &task) const {
        const Patch &patch = m_patches[task.patch];
        return {patch.name,
                [this, &patch](const fs::path &scratch) {
                    return apply(patch, m_options.places.project / "tests" / "submissions",
                                 scratch);
                },
                {seedOf(task.round), task.ownItem ? patch.item : ""}};
    }

    void add(const Task &task, const Judgement &judgement) {
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
    }

    Options m_options;
    std::vector<Patch> m_patches;
    std::vector<Task> m_tasks;
    std::vector<std::map<std::pair<bool, int>, Judgement>> m_judgements; ///< by patch
    std::size_t m_done = 0;
    Failures m_failures;
};

} // namespace

int measure(int argc, char **argv) {
    const std::string verb = argv[0];
    const bool mutants = verb == "mutants";
    Options options;
    options.whole = mutants ? 1 : 5;
    options.seeds = mutants ? 4 : 0;
    CLI::App app(mutants ? "Grades every mutant: one mistake each, which has to cost its item, and "
                           "nothing else."
                         : "Grades every correct variant, which must lose nothing.",
                 "./run " + verb);
    addRunOptions(app, options);
    app.add_option("--whole", options.whole, "Gradings of each whole hand-in, a seed each")
        ->check(CLI::Range(0, 10'000))
        ->capture_default_str();
    if (mutants)
        app.add_option("--seeds", options.seeds, "Gradings of each one's own item, further seeds")
            ->check(CLI::Range(0, 10'000))
            ->capture_default_str();
    if (const std::optional<int> code = parseCommandLine(app, argc, argv))
        return *code;

    catchInterrupts();
    const std::string commit = commitOf(options.places.project); // later it may be another one
    Measurement measurement(options, verb);
    measurement.run();
    const std::vector<PatchRecord> records = measurement.records();
    const Failures &failures = measurement.failures();
    fmt::print("\n{}{}", summarise(records), failures.describe());
    if (isInterrupted()) {
        fmt::print(stderr, "interrupted: {} of {} gradings done; call again to go on\n",
                   measurement.done(), measurement.tasks());
        return kInterrupted;
    }
    if (!options.record.empty())
        replaceSection(options.record, verb, markdown(records, commit) + failures.describe());
    return reachesWanted(records) && failures.setAside.empty() ? 0 : 1;
}

} // namespace exam
