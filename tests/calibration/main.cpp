// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>

#include <cstdio>

#include "runs.h"

namespace {

struct Options {
    int runs = 2000;
    int judgements = 100;
    int stages = 0;
    std::uint64_t seed = 1;
    bool power = false;
    std::string only;
};

/// \return  the exit code
int calibrate(int argc, char **argv) {
    Options options;
    CLI::App app(
        "Calibrates the scene-level statistics of the grader, in this process, on samples of\n"
        "our own renderer recorded once per scene of scenes/grading.\n"
        "Exit code: 0 as it must be, 1 not, 2 the runs could not be made.",
        "calibrate");
    app.add_option("--runs", options.runs, "Runs of each statistic per scene")
        ->check(CLI::Range(10, 1000000))
        ->capture_default_str();
    app.add_option("--seed", options.seed, "Of scenes and runs")->capture_default_str();
    app.add_flag("--power", options.power,
                 "Plant mistakes and see how often they are found, instead of the null");
    app.add_option("--judgements", options.judgements,
                   "With --power: whole judgements per mistake; each takes 0.2 s")
        ->check(CLI::Range(1, 10000))
        ->capture_default_str();
    app.add_option("--stages", options.stages,
                   "So many whole judgements of correct code per scene or check instead: how often "
                   "the first stage rejects")
        ->check(CLI::Range(1, 1000000));
    app.add_option(
           "--only", options.only,
           "With --power: mistakes with this in their names; with --stages: cells, images or "
           "noise alone")
        ->type_name("TEXT");
    CLI11_PARSE(app, argc, argv);
    if (options.stages > 0) {
        calibration::runStages(options.stages, options.only, options.seed);
        return 0;
    }
    if (!options.power)
        return calibration::runNull(options.runs, options.seed) ? 0 : 1;
    const bool statistics =
        calibration::runPowerOfStatistics(options.runs, options.only, options.seed);
    const bool judgements =
        calibration::runJudgements(options.judgements, options.only, options.seed);
    return statistics && judgements ? 0 : 1;
}

} // namespace

int main(int argc, char **argv) {
    try {
        return calibrate(argc, argv);
    } catch (const std::exception &error) {
        std::fprintf(stderr, "calibrate: %s\n", error.what());
        return 2;
    }
}
