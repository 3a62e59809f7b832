// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace exam {

/// How a program ended and what it wrote.
struct Outcome {
    int exitCode = 0; ///< 128 + signal if a signal ended it, as shells say
    std::string output;
    std::string errors;
    double seconds = 0;
};

/// Runs a program to its end.
/// \param command  program and arguments; no shell is involved
/// \param scratch  an existing folder; it is the program's TMPDIR below `tmp`, which is made and
///                 kept, and what the program writes passes through files in it
/// \throws ExamError  if it cannot be started
Outcome runCommand(const std::vector<std::string> &command, const std::filesystem::path &scratch);

} // namespace exam
