// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <viewer/report.h>

namespace viewer {

/// Parameters, verdict, health list, remarks and maps: the same bytes for the same settings.
std::string reportJson(const Subject &subject, const TestReport &report);

/// One document of reportJson()'s objects, with `schema` and `version`.
std::string documentJson(const std::vector<std::string> &reports);

} // namespace viewer
