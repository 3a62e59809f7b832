// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "command_line.h"
#include <viewer/subject.h>

enum class ExitCode {
    Pass = 0,
    Fail = 1,  ///< also: an error
    Usage = 2, ///< also: no window can be opened
    Inconclusive = 3,
};

/// Tests what the command line names, without a window, and writes everything it asks for.
/// \return  the worst of the verdicts
ExitCode runTests(const CommandLine &line, const std::vector<viewer::Subject> &subjects);
