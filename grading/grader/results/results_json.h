// SPDX-License-Identifier: MIT
#pragma once

#include <grader/results/results.h>

#include <string>

namespace grader {

/// The run as JSON, ending in a line end; its shape is results.schema.json beside this file.
/// Numbers that do not apply, and points where no marks are given, are null. Everything but the
/// objects `times` depends only on the hand-ins, the rubric, the base, the compiler and the seed.
std::string resultsJson(const RunResult &run);

} // namespace grader
