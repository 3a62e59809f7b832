// SPDX-License-Identifier: MIT
#pragma once

#include <grader/diagnosis/catalogue.h>
#include <grader/results/results.h>

#include <cstddef>
#include <string>

namespace grader {

/// What the terminal that a report goes to can show.
struct TerminalStyle {
    std::size_t width = 0;                 ///< columns; 0: lines are never broken
    bool colour = false;                   ///< a verdict is always a word as well
    bool unicodeSigns = false;             ///< a tick and a cross instead of `+` and `x`
    Language language = Language::English; ///< of diagnoses and hints
};

/// A table of one hand-in: item, points, verdict, reason; then the sum, what a person should know,
/// and which files were used. Nothing that came from the hand-in can drive the terminal.
std::string terminalReport(const SubmissionResult &result, const TerminalStyle &style);

/// `100 of 100`; for a hand-in without marks how many items are right; `not graded` if it was not.
std::string sumLine(const SubmissionResult &result);

} // namespace grader
