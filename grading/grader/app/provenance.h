// SPDX-License-Identifier: MIT
#pragma once

#include <grader/results/results.h>
#include <grader/rubric/rubric.h>

namespace grader {

/// What the marks of a run of this program, on this machine, rest on.
Provenance provenanceOf(const Rubric &rubric);

} // namespace grader
