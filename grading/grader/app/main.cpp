// SPDX-License-Identifier: MIT
#include <grader/app/terminal.h>
#include <grader/app/verbs.h>

#include <fmt/core.h>

#include <malloc.h>

#include <clocale>
#include <exception>

namespace grader {

ExitCode run(const PrintCommand &command) {
    fmt::print("{}", command.text);
    return ExitCode::Done;
}

ExitCode run(const UsageMistake &mistake) {
    complain(mistake.message);
    return ExitCode::Usage;
}

} // namespace grader

namespace {

/// Arrays of some megabytes come and go with every answer of a probe. To give their pages back to
/// the system each time, and to get them anew, would cost a fifth of a grading.
void keepPages() {
    ::mallopt(M_MMAP_THRESHOLD, 32 << 20); // the most that the C library takes
    ::mallopt(M_TRIM_THRESHOLD, 256 << 20);
}

} // namespace

int main(int argc, char **argv) {
    keepPages();
    // Archives' names are decoded by the locale, and must not depend on who calls.
    if (std::setlocale(LC_CTYPE, "C.UTF-8") == nullptr)
        std::setlocale(LC_CTYPE, "");
    try {
        const grader::Command command =
            grader::parseCommandLine(std::vector<std::string>(argv + 1, argv + argc));
        return static_cast<int>(
            std::visit([](const auto &chosen) { return grader::run(chosen); }, command));
    } catch (const std::exception &error) {
        grader::complain(error.what());
        return static_cast<int>(grader::ExitCode::Infra);
    }
}
