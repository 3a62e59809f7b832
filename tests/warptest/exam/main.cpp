// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>

#include "runs.h"

namespace {

/// \return  the exit code
int examine(int argc, char **argv) {
    CLI::App app("Examines the battery of warptest, in this process.\n"
                 "Exit code: 0 as it must be, 1 not, 2 the runs could not be made.",
                 "warp_exam");
    app.require_subcommand(1);
    warp_exam::NullOptions null;
    CLI::App &calibrate = *app.add_subcommand(
        "calibrate", "Levels of the statistics, and whole batteries, on right warps");
    calibrate.add_option("--runs", null.runs, "Of each statistic, for each warp; 0 for none")
        ->check(CLI::Range(0, 10000000))
        ->capture_default_str();
    calibrate.add_option("--samples", null.samples, "Of each run")
        ->check(CLI::Range(std::size_t{1024}, std::size_t{1} << 24U))
        ->capture_default_str();
    calibrate.add_option("--batteries", null.batteries, "Whole batteries, over all right warps")
        ->check(CLI::Range(0, 1000000))
        ->capture_default_str();
    calibrate.add_option("--warp", null.warp, "Only warps whose name holds this")
        ->type_name("TEXT");
    calibrate.add_option("--seed", null.seed, "Of all random numbers")->capture_default_str();
    warp_exam::PowerOptions power;
    CLI::App &mutants = *app.add_subcommand(
        "power", "Wrong warps and densities: what is found, beside Nori's own test");
    mutants.add_option("--seeds", power.seeds, "Batteries for each of them")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    mutants.add_option("--warp", power.warp, "Only those whose name holds this")->type_name("TEXT");
    CLI11_PARSE(app, argc, argv);
    return (calibrate.parsed() ? warp_exam::runNull(null) : warp_exam::runPower(power)) ? 0 : 1;
}

} // namespace

int main(int argc, char **argv) {
    try {
        return examine(argc, argv);
    } catch (const std::exception &error) {
        std::fprintf(stderr, "warp_exam: %s\n", error.what());
        return 2;
    }
}
