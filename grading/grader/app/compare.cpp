// SPDX-License-Identifier: MIT
#include <grader/app/terminal.h>
#include <grader/app/verbs.h>
#include <grader/error.h>
#include <grader/images/comparison.h>
#include <grader/images/read_image.h>
#include <grader/images/tile_map.h>
#include <grader/report/comparison_report.h>
#include <grader/text_file.h>

#include <fmt/core.h>

#include <unistd.h>

namespace grader {

namespace {

Comparison compare(const CompareCommand &command) {
    const Sandbox sandbox;
    const protocol::Image image = readImage(sandbox, command.image);
    std::vector<protocol::Image> references;
    for (const std::filesystem::path &file : command.references)
        references.push_back(readImage(sandbox, file));
    return compareImages(image, references,
                         {.significance = command.level, .referenceCount = command.referenceSpp});
}

} // namespace

ExitCode run(const CompareCommand &command) {
    Comparison comparison;
    try {
        comparison = compare(command);
        if (!command.tiles.empty())
            writeTextFile(command.tiles, tileMapPng(comparison));
    } catch (const GraderError &error) {
        complain(error.what());
        return ExitCode::Usage;
    }
    ComparedFiles files{command.image.string(), {}};
    for (const std::filesystem::path &file : command.references)
        files.references.push_back(file.string());
    fmt::print("{}", command.json
                         ? comparisonJson(files, comparison)
                         : comparisonReport(files, comparison, terminalStyle(STDOUT_FILENO)));
    switch (comparison.likeness) {
    case Likeness::Alike:
        return ExitCode::Done;
    case Likeness::Different:
        return ExitCode::CheckFailed;
    case Likeness::CannotTell:
        break;
    }
    return ExitCode::NeedsHuman;
}

} // namespace grader
