// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "command_line.h"
#include <viewer/report.h>

/// Observed and expected counts of the maps, row 0 at the map's lower edge. Matlab's has the
/// stock tool's names, obsFrequencies and expFrequencies, for several tests as fields of `tests`.
/// CSV has one line per cell. A test that threw has no counts.
/// \param format  not None
std::string dumpText(DumpFormat format, const std::vector<viewer::Tested> &tests);
