// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "grading_queue.h"

namespace CLI { // NOLINT: the library's name
class App;
}

namespace exam {

/// What every verb that keeps its results can be told.
struct RunOptions {
    GradingPlaces places;
    std::filesystem::path record; ///< Markdown file; empty: none
    std::string only;
    int jobs; ///< gradings at the same time

    RunOptions(); ///< with a job for each core
};

/// Adds them, and a footer with the exit codes.
void addRunOptions(CLI::App &app, RunOptions &options);

/// A required path that `./run` passes, and `--help` therefore leaves out.
void addPlace(CLI::App &app, const char *name, std::filesystem::path &place);

/// `--only` and `--record`, which exclude each other: a table is written whole.
void addOnlyAndRecord(CLI::App &app, std::string &only, std::filesystem::path &record);

/// \return  the exit code if that was all: 0 after `--help`, 2 after a mistake
std::optional<int> parseCommandLine(CLI::App &app, int argc, char **argv);

} // namespace exam
