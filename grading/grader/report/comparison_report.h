// SPDX-License-Identifier: MIT
#pragma once

#include <grader/images/comparison.h>
#include <grader/report/terminal_report.h>

#include <string>

namespace grader {

/// What of a comparison a report names: the files as the user gave them.
struct ComparedFiles {
    std::string image;
    std::vector<std::string> references;
};

/// A verdict with its reasons, and a table with a row per channel.
std::string comparisonReport(const ComparedFiles &files, const Comparison &comparison,
                             const TerminalStyle &style);

/// The same as JSON, with every tile; its shape is comparison.schema.json beside this file.
std::string comparisonJson(const ComparedFiles &files, const Comparison &comparison);

} // namespace grader
