// SPDX-License-Identifier: MIT
#pragma once

#include <grader/calibration/corpus.h>
#include <grader/checks/check.h>
#include <grader/results/results.h>
#include <grader/rubric/rubric.h>

#include <string>
#include <vector>

namespace grader {

/// What a rubric makes of one hand-in that it must not: a sentence each, with what to change.
/// \param outcomes  of all checks of the rubric's items, as measured: they depend on no weight
std::vector<std::string> judgeCase(const Rubric &rubric, const CorpusCase &which,
                                   const std::vector<CheckResult> &outcomes);

} // namespace grader
