// SPDX-License-Identifier: MIT
#include "command.h"

#include <grader/text_file.h>

#include <fmt/format.h>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>

#include "expectation.h"

namespace exam {

namespace {

namespace fs = std::filesystem;

std::vector<char *> pointers(std::vector<std::string> &texts) {
    std::vector<char *> result;
    result.reserve(texts.size() + 1);
    for (std::string &text : texts)
        result.push_back(text.data());
    result.push_back(nullptr);
    return result;
}

/// Our environment with another TMPDIR.
std::vector<std::string> environmentWith(const fs::path &temporary) {
    std::vector<std::string> result = {"TMPDIR=" + temporary.string()};
    for (char **variable = environ; *variable != nullptr; ++variable) {
        if (std::strncmp(*variable, "TMPDIR=", 7) != 0)
            result.emplace_back(*variable);
    }
    return result;
}

} // namespace

Outcome runCommand(const std::vector<std::string> &command, const fs::path &scratch) {
    const fs::path temporary = scratch / "tmp";
    fs::create_directories(temporary);
    // Files rather than pipes: a process that is left behind cannot keep us waiting.
    const fs::path output = scratch / "stdout";
    const fs::path errors = scratch / "stderr";
    posix_spawn_file_actions_t actions{};
    posix_spawn_file_actions_init(&actions);
    const int flags = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output.c_str(), flags, 0600);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, errors.c_str(), flags, 0600);

    std::vector<std::string> arguments = command;
    std::vector<std::string> variables = environmentWith(temporary);
    const auto start = std::chrono::steady_clock::now();
    pid_t child = 0;
    const int error = posix_spawnp(&child, command.front().c_str(), &actions, nullptr,
                                   pointers(arguments).data(), pointers(variables).data());
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0)
        throw ExamError(fmt::format("{}: {}", command.front(), std::strerror(error)));
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    Outcome outcome;
    outcome.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    outcome.output = grader::readTextFile(output);
    outcome.errors = grader::readTextFile(errors);
    outcome.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return outcome;
}

} // namespace exam
