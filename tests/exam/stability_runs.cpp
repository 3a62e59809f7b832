// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "command.h"
#include "hand_in.h"
#include "patch.h"
#include "run_options.h"
#include "stability.h"
#include "summary.h"

namespace exam {

namespace {

namespace fs = std::filesystem;

/// Of tests/submissions: the reference, and mistakes in points of a mesh and in images. What is
/// borderline stands in tests/borderline.
const std::vector<std::string> kAccepted = {"accepted/reference"};
const std::vector<std::string> kWrong = {"wrong/mesh_first_triangle_only", "wrong/ems_no_pick_pdf"};

struct Options : RunOptions {
    fs::path unoptimised; ///< norigrade that builds hand-ins with -O0
    int seeds = 60;
    int settings = 3;
};

/// A hand-in and how it is put together.
struct StableHandIn {
    StabilityRecord record;
    std::function<fs::path(const fs::path &scratch)> compose;
};

std::vector<StableHandIn> findHandIns(const Options &options) {
    const fs::path submissions = options.places.project / "tests" / "submissions";
    std::vector<StableHandIn> found;
    const auto isWanted = [&](const std::string &name) {
        return name.find(options.only) != std::string::npos;
    };
    const auto addCase = [&](const std::string &name, Standing standing) {
        if (!isWanted(name))
            return;
        const Case which = findCases(submissions, name).front();
        found.push_back(
            {{name, "", standing, {}, {}, {}},
             [submissions, which, norigrade = options.places.norigrade](const fs::path &scratch) {
                 return compose(submissions, which, norigrade, scratch);
             }});
    };
    for (const std::string &name : kAccepted)
        addCase(name, Standing::Accepted);
    for (const Patch &patch : findPatches(options.places.project / "tests" / "borderline", "")) {
        const std::string name = "borderline/" + patch.name;
        if (isWanted(name))
            found.push_back({{name, patch.what, Standing::Borderline, {}, {}, {}},
                             [submissions, patch](const fs::path &scratch) {
                                 return apply(patch, submissions, scratch);
                             }});
    }
    for (const std::string &name : kWrong)
        addCase(name, Standing::Wrong);
    if (found.empty())
        throw ExamError(fmt::format("no hand-in has \"{}\" in its name", options.only));
    return found;
}

/// Which gradings of a record a task belongs to.
enum class Setting { Seed, Pair, Plain };

struct Place {
    std::size_t handIn = 0;
    Setting setting = Setting::Seed;
    int round = 0;
};

std::vector<Graded> &gradingsOf(StabilityRecord &record, Setting setting) {
    switch (setting) {
    case Setting::Pair:
        return record.pairs;
    case Setting::Plain:
        return record.plain;
    case Setting::Seed:
        break;
    }
    return record.seeds;
}

/// \return  how many are done; what is set aside stays empty
std::size_t grade(const Options &options, const fs::path &norigrade,
                  const std::vector<Place> &where, std::vector<StableHandIn> &handIns,
                  Failures &failures) {
    GradingPlaces places = options.places;
    places.norigrade = norigrade;
    GradingQueue queue(places, options.jobs);
    std::vector<GradingTask> tasks;
    for (const Place &place : where) {
        const StableHandIn &handIn = handIns[place.handIn];
        tasks.push_back({handIn.record.name,
                         handIn.compose,
                         {seedOf(place.round), ""},
                         place.setting == Setting::Pair ? 2 : 1});
        gradingsOf(handIns[place.handIn].record, place.setting).emplace_back();
    }
    const std::size_t done = queue.run(tasks, [&](std::size_t at, const std::string &json) {
        const Place &place = where[at];
        StabilityRecord &record = handIns[place.handIn].record;
        const Graded graded = parseResults(json);
        gradingsOf(record, place.setting)[static_cast<std::size_t>(place.round)] = graded;
        fmt::print("{:<40} seed {:<3} {:<14} {}\n", record.name, place.round,
                   place.setting == Setting::Pair    ? "two processes"
                   : place.setting == Setting::Plain ? "-O0"
                                                     : "",
                   describe(graded));
        std::cout << std::flush;
    });
    failures.add(queue.failures());
    return done;
}

/// Whether none of its gradings was set aside: only then its figures can be compared.
bool isComplete(const StabilityRecord &record) {
    for (const std::vector<Graded> *gradings : {&record.seeds, &record.pairs, &record.plain}) {
        if (std::any_of(gradings->begin(), gradings->end(),
                        [](const Graded &graded) { return graded.items.empty(); }))
            return false;
    }
    return true;
}

/// One round over all hand-ins after the other, so that what is interrupted has seen all.
std::vector<Place> rounds(std::size_t handIns, Setting setting, int count) {
    std::vector<Place> places;
    for (int round = 0; round < count; ++round) {
        for (std::size_t i = 0; i < handIns; ++i)
            places.push_back({i, setting, round});
    }
    return places;
}

/// What the grader composes its chance of a false alarm of.
std::string describeFalseAlarms(const GradingPlaces &places, const std::string &commit) {
    const WorkFolder work;
    const fs::path rubric = places.project / "grading" / "rubrics" / "assignment-2.toml";
    const Outcome outcome = runCommand(
        {places.norigrade.string(), "calibrate", rubric.string(), "--bound"}, work.path());
    if (outcome.exitCode != 0)
        throw ExamError(fmt::format("norigrade calibrate: {}", outcome.errors));
    return fmt::format("Composed at commit `{}`.\n\n```text\n{}```\n", commit, outcome.output);
}

} // namespace

int measureStability(int argc, char **argv) {
    Options options;
    CLI::App app("Grades the same right, borderline and wrong hand-ins again and again: with other "
                 "seeds, with two\nprocesses at the same time, and built without optimisation.",
                 "./run stability");
    addRunOptions(app, options);
    addPlace(app, "--unoptimised", options.unoptimised);
    app.add_option("--seeds", options.seeds, "Gradings of each hand-in, a seed each")
        ->check(CLI::Range(1, 10'000))
        ->capture_default_str();
    app.add_option("--settings", options.settings,
                   "Seeds that are graded with two processes and with -O0, too")
        ->check(CLI::Range(0, 10'000))
        ->capture_default_str();
    if (const std::optional<int> code = parseCommandLine(app, argc, argv))
        return *code;
    options.settings = std::min(options.settings, options.seeds);

    catchInterrupts();
    const std::string commit = commitOf(options.places.project); // later it may be another one
    std::vector<StableHandIn> handIns = findHandIns(options);
    std::vector<Place> optimised = rounds(handIns.size(), Setting::Seed, options.seeds);
    const std::vector<Place> pairs = rounds(handIns.size(), Setting::Pair, options.settings);
    const std::vector<Place> plain = rounds(handIns.size(), Setting::Plain, options.settings);
    optimised.insert(optimised.end(), pairs.begin(), pairs.end());
    Failures failures;
    std::size_t done = grade(options, options.places.norigrade, optimised, handIns, failures);
    if (!isInterrupted())
        done += grade(options, options.unoptimised, plain, handIns, failures);
    if (isInterrupted()) {
        fmt::print(stderr, "interrupted: {} of {} gradings done; call again to go on\n", done,
                   optimised.size() + plain.size());
        return kInterrupted;
    }
    std::vector<StabilityRecord> records;
    for (const StableHandIn &handIn : handIns) {
        if (isComplete(handIn.record))
            records.push_back(handIn.record);
    }
    fmt::print("\n{}{}", describeStability(records), failures.describe());
    if (!options.record.empty()) {
        replaceSection(options.record, "stability",
                       stabilityMarkdown(records, commit) + failures.describe());
        replaceSection(options.record, "false-alarms", describeFalseAlarms(options.places, commit));
    }
    const bool right =
        std::all_of(records.begin(), records.end(),
                    [](const StabilityRecord &record) { return record.asExpected(); });
    return right && failures.setAside.empty() ? 0 : 1;
}

} // namespace exam
