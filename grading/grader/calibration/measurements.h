// SPDX-License-Identifier: MIT
#pragma once

#include <grader/results/results.h>

#include <filesystem>
#include <optional>
#include <vector>

namespace grader {

/// What checks measured on one hand-in, kept between calls: verdicts and effects, no points.
/// \throws GraderError  if it cannot be written
void writeMeasurements(const std::filesystem::path &file, const std::vector<CheckResult> &checks);

/// \return  nothing if there is no such file, or it is damaged
std::optional<std::vector<CheckResult>> readMeasurements(const std::filesystem::path &file);

} // namespace grader
