// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "command_line.h"
#include <viewer/report.h>

// What needs the packages of NORI_GUI; without them the functions throw a sentence that says so.

/// Shows the window, or draws it into a file.
void showWarpWindow(const CommandLine &line, const std::vector<viewer::Subject> &subjects);

/// Writes picture and data of a test. \return  the picture's path
std::string saveEvidence(const viewer::Subject &subject, const viewer::TestReport &report,
                         const std::string &folder);
