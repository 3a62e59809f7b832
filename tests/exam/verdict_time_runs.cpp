// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>

#include "hand_in.h"
#include "patch.h"
#include "run_options.h"
#include "summary.h"
#include "verdict_times.h"

namespace exam {

namespace {

namespace fs = std::filesystem;

constexpr int kProcesses = 2; ///< "on 2 cores"

struct Options {
    fs::path project;
    fs::path norigrade;
    fs::path record; ///< Markdown file; empty: none
    std::string only;
    int count = 12;
};

struct TimedHandIn {
    std::string name;
    bool isRight = false;
    std::function<fs::path(const fs::path &scratch)> compose;
};

/// So many of them, evenly spaced.
template <typename T>
std::vector<T> some(const std::vector<T> &all, int count) {
    std::vector<T> chosen;
    const std::size_t wanted = std::min(all.size(), static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < wanted; ++i)
        chosen.push_back(all[i * all.size() / wanted]);
    return chosen;
}

std::vector<TimedHandIn> findHandIns(const Options &options) {
    const fs::path submissions = options.project / "tests" / "submissions";
    std::vector<TimedHandIn> right;
    std::vector<TimedHandIn> wrong;
    std::vector<TimedHandIn> subtle;
    for (const Case &which : findCases(submissions, "")) {
        const bool isRight = which.name.rfind("accepted/", 0) == 0;
        if (!isRight && which.name.rfind("wrong/", 0) != 0)
            continue;
        (isRight ? right : wrong)
            .push_back({which.name, isRight,
                        [submissions, which, norigrade = options.norigrade](const fs::path &to) {
                            return compose(submissions, which, norigrade, to);
                        }});
    }
    const auto addPatches = [&](const std::string &folder, Patch::Cost cost,
                                std::vector<TimedHandIn> &to) {
        for (const Patch &patch : findPatches(options.project / "tests" / folder, "")) {
            if (patch.cost == cost)
                to.push_back({fmt::format("{}/{}", folder, patch.name), false,
                              [submissions, patch](const fs::path &scratch) {
                                  return apply(patch, submissions, scratch);
                              }});
        }
    };
    addPatches("mutants", Patch::Cost::Visible, wrong);
    addPatches("borderline", Patch::Cost::Visible, subtle);
    addPatches("mutants", Patch::Cost::Latent, subtle);
    std::vector<TimedHandIn> all;
    for (std::vector<TimedHandIn> *list : {&right, &wrong, &subtle}) {
        std::erase_if(*list, [&](const TimedHandIn &handIn) {
            return handIn.name.find(options.only) == std::string::npos;
        });
        const std::vector<TimedHandIn> chosen = some(*list, options.count);
        all.insert(all.end(), chosen.begin(), chosen.end());
    }
    if (all.empty())
        throw ExamError(fmt::format("no hand-in has \"{}\" in its name", options.only));
    return all;
}

/// Makes every source a new one for the cache of objects, as a student's is.
void makeNew(const fs::path &handIn, const std::string &mark) {
    if (!fs::is_directory(handIn))
        return; // packed: only what it is laid over is known
    for (const auto &entry : fs::recursive_directory_iterator(handIn)) {
        const fs::path &file = entry.path();
        if (entry.is_regular_file() && (file.extension() == ".cpp" || file.extension() == ".h"))
            std::ofstream(file, std::ios::app) << "\n// " << mark << "\n";
    }
}

std::map<std::string, double> phasesOf(const std::string &json) {
    try {
        return nlohmann::json::parse(json)
            .at("submissions")
            .at(0)
            .at("times")
            .get<std::map<std::string, double>>();
    } catch (const nlohmann::json::exception &error) {
        throw ExamError(fmt::format("norigrade's JSON: {}", error.what()));
    }
}

/// An empty cache, which other users can read and which already has the base.
void prepareCache(const Options &options, const fs::path &folder, const fs::path &scratch) {
    fs::permissions(folder,
                    fs::perms::group_exec | fs::perms::others_exec | fs::perms::group_read |
                        fs::perms::others_read,
                    fs::perm_options::add);
    ::setenv("NORIGRADE_CACHE", (folder / "cache").c_str(), 1);
    fs::create_directories(scratch);
    const fs::path submissions = options.project / "tests" / "submissions";
    const Case which = findCases(submissions, "accepted/reference").front();
    gradeToJson(options.norigrade, compose(submissions, which, options.norigrade, scratch),
                {seedOf(0), ""}, kProcesses, scratch);
}

VerdictTime measure(const Options &options, const TimedHandIn &handIn, int attempt,
                    const ItemClock &clock, const fs::path &scratch) {
    fs::create_directories(scratch);
    const fs::path folder = handIn.compose(scratch);
    makeNew(folder, fmt::format("{} {}", handIn.name, attempt));
    VerdictTime time{handIn.name, handIn.isRight, {}, {}};
    time.phases =
        phasesOf(gradeToJson(options.norigrade, folder, {seedOf(0), ""}, kProcesses, scratch));
    if (!handIn.isRight)
        time.items = clock.measure(folder, handIn.name, seedOf(0));
    return time;
}

/// \return  nothing if the grader itself fails again and again
std::optional<VerdictTime> tryToMeasure(const Options &options, const TimedHandIn &handIn,
                                        const ItemClock &clock, const fs::path &work,
                                        const Progress &progress, Failures &failures) {
    std::optional<VerdictTime> time;
    for (int attempt = 0; attempt < kTries && !time && !isInterrupted(); ++attempt) {
        const fs::path scratch = work / fmt::format("attempt{}", attempt);
        try {
            time = measure(options, handIn, attempt, clock, scratch);
            failures.repeated += attempt > 0 ? 1 : 0;
        } catch (const InfraError &error) {
            progress.clear();
            fmt::print(stderr, "{}: {}\n", handIn.name, error.what());
        }
        std::error_code ignored;
        fs::remove_all(scratch, ignored);
    }
    return time;
}

void print(const VerdictTime &time) {
    fmt::print("{:<48} {:<14} {:6.1f} s\n", time.name, time.kind(), time.phases.at("total"));
    for (const ItemTime &item : time.items)
        fmt::print("    {:<20} {}{:.2f} s of sampling, {:.2f} of CPU; judging {:.2f}; {} {:.2f}\n",
                   item.item,
                   item.isGross ? fmt::format("gross after {:.2f} s, {:.2f} of CPU; ",
                                              item.decidedWall, item.decidedCpu)
                                : "",
                   item.samplingWall, item.samplingCpu, item.judgingCpu, item.slowest,
                   item.slowestCpu);
    std::cout << std::flush;
}

/// Until it is interrupted; `times` and `failures` hold what there was by then.
void measureAll(const Options &options, const std::vector<TimedHandIn> &handIns,
                const fs::path &work, std::vector<VerdictTime> &times, Failures &failures) {
    const ItemClock clock;
    Progress progress(handIns.size());
    for (const TimedHandIn &handIn : handIns) {
        const std::optional<VerdictTime> time =
            tryToMeasure(options, handIn, clock, work, progress, failures);
        if (isInterrupted())
            return;
        progress.clear();
        if (time) {
            times.push_back(*time);
            print(*time);
        } else
            failures.setAside.push_back(handIn.name);
        progress.add();
    }
}

} // namespace

int measureVerdictTimes(int argc, char **argv) {
    Options options;
    CLI::App app("Measures how long hand-ins take that nobody has compiled before: by phase with "
                 "two processes, and per\nlost item until it is decided. For a quiet machine.",
                 "./run verdict-times");
    addPlace(app, "--project", options.project);
    addPlace(app, "--norigrade", options.norigrade);
    addOnlyAndRecord(app, options.only, options.record);
    app.add_option("--count", options.count,
                   "Hand-ins of each kind, evenly spaced: right ones, visibly wrong ones of "
                   "tests/submissions and tests/mutants, and subtly wrong ones")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.footer("Times are measured anew in every call.\nExit codes: 0 every grossly wrong item is "
               "decided in time, 1 some are not, 2 usage, or the grader or a hand-in fails,\n"
               "75 interrupted.");
    if (const std::optional<int> code = parseCommandLine(app, argc, argv))
        return *code;

    catchInterrupts();
    const std::string commit = commitOf(options.project); // later it may be another one
    const std::vector<TimedHandIn> handIns = findHandIns(options);
    const WorkFolder work;
    std::vector<VerdictTime> times;
    Failures failures;
    try {
        prepareCache(options, work.path(), work.path() / "base");
        measureAll(options, handIns, work.path(), times, failures);
    } catch (const std::exception &) {
        if (!isInterrupted()) // what fails then was ended by the same Ctrl-C
            throw;
    }
    fmt::print("\n{}{}", describeTimes(times), failures.describe());
    if (isInterrupted()) {
        fmt::print(stderr, "interrupted: {} of {} hand-ins measured\n", times.size(),
                   handIns.size());
        return kInterrupted;
    }
    if (!options.record.empty())
        replaceSection(options.record, "verdict-times",
                       timesMarkdown(times, commit) + failures.describe());
    return lateItems(times).empty() && failures.setAside.empty() ? 0 : 1;
}

} // namespace exam
