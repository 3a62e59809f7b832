// SPDX-License-Identifier: MIT
#pragma once

#include <grader/prober/prober.h>
#include <grader/results/results.h>
#include <statistics/triple_lock.h>

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

/// Puts `diagnosis` before the guesses, which look at the last stage only, where the stages have
/// confirmed errors that differ: something is kept from the start of the program.
std::vector<Guess> explain(const statistics::LockResult &lock, std::vector<Guess> guesses,
                           const char *diagnosis = "samples.kept");

} // namespace grader
