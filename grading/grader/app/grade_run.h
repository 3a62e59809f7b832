// SPDX-License-Identifier: MIT
#pragma once

#include <grader/app/command_line.h>
#include <grader/app/exit_code.h>
#include <grader/engine/engine.h>
#include <grader/results/results.h>
#include <grader/rubric/rubric.h>

#include <atomic>
#include <filesystem>
#include <functional>
#include <vector>

namespace grader {

/// Builds and tests one hand-in: Engine::grade, or a stand-in in tests.
using GradeFunction = std::function<SubmissionResult(const Submission &, const ProgressCallback &)>;

/// What a run is given besides its command line.
struct GradeRun {
    const GradeCommand &command; ///< with its seed and folder decided
    const Rubric &rubric;        ///< with its checks resolved
    const Provenance &provenance;
    const std::atomic<bool> &interrupted;
    std::string sandbox; ///< level, for hand-ins that could not be tested
};

/// Grades one hand-in after the other, prints each as it is done, and keeps results.json and the
/// pages up to date, so that what was done outlives an interruption. A hand-in that cannot be read
/// or tested is a result as well; the others go on.
/// \throws GraderError  if the results cannot be written
ExitCode gradeAll(const GradeRun &run, const GradeFunction &grade);

/// What a finished run tells its caller: the gravest of what its results say.
ExitCode exitCodeOf(const std::vector<SubmissionResult> &results);

} // namespace grader
