// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "grading_queue.h"

namespace CLI {
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

} // namespace exam
