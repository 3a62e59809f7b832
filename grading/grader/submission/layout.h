// SPDX-License-Identifier: MIT
#pragma once

#include <grader/submission/raw_files.h>
#include <grader/submission/submission.h>

#include <vector>

namespace grader {

/// Gives each file of a hand-in its role, by its name wherever it lies: sources that replace the
/// base's, headers, further sources, README, figures; the others are ignored, each with its reason.
///
/// Copies (`area_COPY.cpp`, `main_old.cpp`) and second files of the same name are left out, since a
/// class that is defined twice does not link; where that was a choice, a note asks for a person.
/// Appends to `submission.files` (sorted by path) and `submission.notes`.
void sortFiles(const std::vector<RawFile> &raw, Submission &submission);

} // namespace grader
