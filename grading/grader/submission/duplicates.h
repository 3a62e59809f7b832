// SPDX-License-Identifier: MIT
#pragma once

#include <grader/submission/submission.h>

namespace grader {

/// Leaves one source and one header of each name: the one in `src/` (headers: `include/nori/`)
/// that is nearest to the root. Others become Ignored; where they differ, a note asks for a person.
/// Also notes paths that differ only in case or Unicode form.
void keepOneOfEach(Submission &submission);

} // namespace grader
