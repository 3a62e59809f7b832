// SPDX-License-Identifier: MIT
#pragma once

#include <grader/rubric/rubric.h>

#include <filesystem>

namespace grader {

/// The rubric of `file`, with its checks resolved against the check table.
/// \param file  empty: the assignment's own
/// \throws GraderError  as readRubric() and resolveChecks()
Rubric loadRubric(const std::filesystem::path &file);

} // namespace grader
