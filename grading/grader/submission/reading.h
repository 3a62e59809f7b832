// SPDX-License-Identifier: MIT
#pragma once

#include <grader/submission/raw_files.h>
#include <grader/submission/submission.h>

#include <filesystem>

namespace grader {

/// readSubmission() with other limits than the usual ones.
Submission readSubmission(const std::filesystem::path &path, const ReadLimits &limits);

} // namespace grader
