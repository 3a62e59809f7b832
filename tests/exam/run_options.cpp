// SPDX-License-Identifier: MIT
#include "run_options.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <thread>

namespace exam {

RunOptions::RunOptions()
    : jobs(std::max(1, static_cast<int>(std::thread::hardware_concurrency()))) {}

void addRunOptions(CLI::App &app, RunOptions &options) {
    addPlace(app, "--project", options.places.project);
    addPlace(app, "--norigrade", options.places.norigrade);
    addPlace(app, "--cache", options.places.cache);
    addOnlyAndRecord(app, options.only, options.record);
    app.add_option("--jobs", options.jobs, "Gradings at the same time")
        ->check(CLI::Range(1, 64))
        ->capture_default_str();
    app.footer("Results are kept: a second call grades only what has changed.\n"
               "Exit codes: 0 as it has to be, 1 not, 2 usage, or the grader or a patch fails,\n"
               "75 interrupted.");
}

void addPlace(CLI::App &app, const char *name, std::filesystem::path &place) {
    app.add_option(name, place)->required()->group(""); // an empty group is not in the help
}

void addOnlyAndRecord(CLI::App &app, std::string &only, std::filesystem::path &record) {
    CLI::Option *part = app.add_option("--only", only, "Only those with this text in their name")
                            ->option_text("TEXT");
    app.add_option("--record", record, "Write the table into this Markdown file")
        ->option_text("FILE")
        ->excludes(part);
}

std::optional<int> parseCommandLine(CLI::App &app, int argc, char **argv) {
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError &error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    return std::nullopt;
}

} // namespace exam
