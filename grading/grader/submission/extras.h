// SPDX-License-Identifier: MIT
#pragma once

#include <grader/submission/submission.h>

namespace grader {

/// Tells further sources from copies of other files, by their names and by what they define. A
/// file that registers a type of the base whose own file was not handed in takes its place.
void sortExtras(Submission &submission);

} // namespace grader
