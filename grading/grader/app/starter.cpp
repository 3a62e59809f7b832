// SPDX-License-Identifier: MIT
#include <grader/app/terminal.h>
#include <grader/app/verbs.h>
#include <grader/build/starter.h>
#include <grader/error.h>

#include <fmt/core.h>

namespace grader {

ExitCode run(const StarterCommand &command) {
    try {
        writeStarter(command.folder);
    } catch (const GraderError &error) {
        complain(error.what());
        return ExitCode::Usage;
    }
    fmt::print("{}: the student edition\n", command.folder.string());
    return ExitCode::Done;
}

} // namespace grader
