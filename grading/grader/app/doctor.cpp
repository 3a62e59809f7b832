// SPDX-License-Identifier: MIT
#include <grader/app/terminal.h>
#include <grader/app/verbs.h>
#include <grader/rubric/rubric.h>
#include <grader/sandbox/box.h>

#include <fmt/core.h>

namespace grader {

ExitCode run(const DoctorCommand & /*command*/) {
    const Sandbox sandbox;
    fmt::print("sandbox level {}\n", sandboxLevelName(sandbox.level()));
    for (const std::string &finding : sandbox.findings())
        fmt::print("  {}\n", finding);
    const SandboxLevel asked = Rubric{}.minSandbox;
    if (sandbox.level() >= asked)
        return ExitCode::Done;
    complain(
        fmt::format("rubrics ask for level {} unless they say otherwise: grading is refused here",
                    sandboxLevelName(asked)));
    return ExitCode::SandboxTooLow;
}

} // namespace grader
