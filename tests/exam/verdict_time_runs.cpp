// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>

#include "grading_queue.h"
#include "hand_in.h"
#include "patch.h"
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
    int count = 8;
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
    for (const char *folder : {"borderline", "mutants"}) {
        for (const Patch &patch : findPatches(options.project / "tests" / folder, "")) {
            if (patch.cost == Patch::Cost::Latent || std::string(folder) == "borderline")
                subtle.push_back({fmt::format("{}/{}", folder, patch.name), false,
                                  [submissions, patch](const fs::path &to) {
                                      return apply(patch, submissions, to);
                                  }});
        }
    }
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

VerdictTime measure(const Options &options, const TimedHandIn &handIn, const ItemClock &clock,
                    const fs::path &scratch) {
    fs::create_directories(scratch);
    const fs::path folder = handIn.compose(scratch);
    makeNew(folder, handIn.name);
    VerdictTime time{handIn.name, handIn.isRight, {}, {}};
    time.phases =
        phasesOf(gradeToJson(options.norigrade, folder, {seedOf(0), ""}, kProcesses, scratch));
    if (!handIn.isRight)
        time.items = clock.measure(folder, handIn.name, seedOf(0));
    return time;
}

} // namespace

int measureVerdictTimes(int argc, char **argv) {
    Options options;
    CLI::App app("Measures how long hand-ins take that nobody has compiled before: by phase with "
                 "two processes, and per\nlost item until it is decided. For a quiet machine.",
                 "./run verdict-times");
    app.add_option("--project", options.project, "The project's folder")->required();
    app.add_option("--norigrade", options.norigrade, "The program to examine")->required();
    app.add_option("--only", options.only, "Only those with this text in their name")
        ->option_text("TEXT");
    app.add_option("--count", options.count,
                   "Hand-ins of each kind: tests/submissions/accepted, wrong, and subtle ones")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--record", options.record, "Write the table into this Markdown file")
        ->option_text("FILE");
    app.footer("Times are measured anew in every call.\nExit codes: 0 every grossly wrong item is "
               "decided in time, 1 some are not, 2 usage, 75 interrupted.");
    CLI11_PARSE(app, argc, argv);

    catchInterrupts();
    const std::vector<TimedHandIn> handIns = findHandIns(options);
    const WorkFolder work;
    prepareCache(options, work.path(), work.path() / "base");
    const ItemClock clock;
    std::vector<VerdictTime> times;
    const auto start = std::chrono::steady_clock::now();
    for (const TimedHandIn &handIn : handIns) {
        if (isInterrupted())
            break;
        const fs::path scratch = work.path() / fmt::format("{}", times.size());
        times.push_back(measure(options, handIn, clock, scratch));
        std::error_code ignored;
        fs::remove_all(scratch, ignored);
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        fmt::print("{:<48} {:<14} {:6.1f} s\n", handIn.name, times.back().kind(),
                   times.back().phases.at("total"));
        for (const ItemTime &item : times.back().items)
            fmt::print(
                "    {:<20} {}{:.2f} s of sampling, {:.2f} of CPU; judging {:.2f}; {} {:.2f}\n",
                item.item,
                item.isGross ? fmt::format("gross after {:.2f} s, {:.2f} of CPU; ",
                                           item.decidedWall, item.decidedCpu)
                             : "",
                item.samplingWall, item.samplingCpu, item.judgingCpu, item.slowest,
                item.slowestCpu);
        std::cout << std::flush;
        if (isatty(STDERR_FILENO) != 0)
            std::cerr << fmt::format("{} of {}, {:.0f} min left\n", times.size(), handIns.size(),
                                     seconds / 60 / static_cast<double>(times.size()) *
                                         static_cast<double>(handIns.size() - times.size()));
    }
    fmt::print("\n{}", describeTimes(times));
    if (isInterrupted())
        return kInterrupted;
    if (!options.record.empty())
        replaceSection(options.record, "verdict-times",
                       timesMarkdown(times, commitOf(options.project)));
    return lateItems(times).empty() ? 0 : 1;
}

} // namespace exam
