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

/// Chance that right code of a class loses anything, composed of levels, never measured.
struct FalseAlarmBound {
    double perHandIn = 0; ///< union bound over the checks that can cost
    double perClass = 0;
    std::size_t checks = 0;             ///< in the bound
    std::vector<std::string> unbounded; ///< checks that decide by a fixed tolerance instead
};

FalseAlarmBound composeBound(const Rubric &rubric, const std::vector<Check> &table, int classSize);

} // namespace grader
