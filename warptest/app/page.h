// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "command_line.h"
#include <viewer/report.h>

/// Writes the page of `--html`.
/// \throws std::runtime_error  if it cannot be written, or gnuplot is missing
void writePage(const CommandLine &line, const std::vector<viewer::Tested> &tests);
