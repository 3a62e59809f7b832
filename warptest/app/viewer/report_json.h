// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <viewer/report.h>

namespace viewer {

/// The document of `warptest --json` (warptest.schema.json), which pictures and pages hold as well.
std::string documentJson(const std::vector<Tested> &tests);

} // namespace viewer
