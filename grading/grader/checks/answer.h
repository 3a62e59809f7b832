// SPDX-License-Identifier: MIT
#pragma once

#include <grader/prober/prober.h>
#include <grader/results/results.h>

#include <optional>
#include <string>
#include <vector>

namespace grader {

/// Turns an answer that cannot be judged into the result it is: Infra when the box did not start,
/// Timeout, Crash, Missing when the code says that it is not implemented, Fail for any other
/// exception. \return  nothing when every request was answered
std::optional<CheckResult> unanswered(const ProbeAnswer &answer);

/// A result with a verdict and what was found; numbers are for the caller to fill in.
CheckResult makeResult(Verdict verdict, std::string message, std::vector<Guess> diagnoses = {});

} // namespace grader
