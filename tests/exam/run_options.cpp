// SPDX-License-Identifier: MIT
#include "run_options.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <thread>

namespace exam {

RunOptions::RunOptions()
    : jobs(std::max(1, static_cast<int>(std::thread::hardware_concurrency()))) {}

void addRunOptions(CLI::App &app, RunOptions &options) {
    app.add_option("--project", options.places.project, "The project's folder")->required();
    app.add_option("--norigrade", options.places.norigrade, "The program to examine")->required();
    app.add_option("--cache", options.places.cache, "Where results are kept")->required();
    app.add_option("--only", options.only, "Only those with this text in their name")
        ->option_text("TEXT");
    app.add_option("--jobs", options.jobs, "Gradings at the same time")
        ->check(CLI::Range(1, 64))
        ->capture_default_str();
    app.add_option("--record", options.record, "Write the table into this Markdown file")
        ->option_text("FILE");
    app.footer("Results are kept: a second call grades only what has changed.\n"
               "Exit codes: 0 all as expected, 1 some not, 2 usage, 75 interrupted.");
}

} // namespace exam
