// SPDX-License-Identifier: MIT
#pragma once

#include <grader/app/command_line.h>
#include <grader/app/exit_code.h>

namespace grader {

// One per verb. Results go to standard output, everything else to standard error.
ExitCode run(const GradeCommand &command);
ExitCode run(const CalibrateCommand &command);
ExitCode run(const DoctorCommand &command);
ExitCode run(const LintCommand &command);
ExitCode run(const StarterCommand &command);
ExitCode run(const ConvergeCommand &command);
ExitCode run(const CompareCommand &command);
ExitCode run(const ReferencesCommand &command);
ExitCode run(const PrintCommand &command);
ExitCode run(const UsageMistake &mistake);

} // namespace grader
