// SPDX-License-Identifier: MIT
#pragma once

namespace grader {

/// What the program tells its caller. None of them says anything about marks but CheckFailed.
enum class ExitCode {
    Done = 0,
    CheckFailed = 1,   ///< `check`: some tests failed; `compare`: the images differ
    Usage = 2,         ///< the command line or the rubric is wrong
    NeedsHuman = 3,    ///< done, but someone has to look; `compare`: it cannot be told
    SandboxTooLow = 4, ///< below what the rubric asks for: nothing was run
    Infra = 5,         ///< something could not be tested or written, through our own fault
    Interrupted = 75,  ///< by SIGINT or SIGTERM; what was done is written
};

} // namespace grader
