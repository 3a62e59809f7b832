// SPDX-License-Identifier: MIT
#include "render_process.h"

#include <grader/error.h>

#include <fmt/core.h>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <vector>

namespace grader {

namespace {

namespace fs = std::filesystem;

constexpr int kInterruptedCode = 130; ///< of `nori`; its image is only a part then

/// Files that go when this does.
class Leftovers {
public:
    explicit Leftovers(std::vector<fs::path> files) : m_files(std::move(files)) {}

    ~Leftovers() {
        std::error_code ignored;
        for (const fs::path &file : m_files)
            fs::remove(file, ignored);
    }

    Leftovers(const Leftovers &) = delete;
    Leftovers(Leftovers &&) = delete;
    Leftovers &operator=(const Leftovers &) = delete;
    Leftovers &operator=(Leftovers &&) = delete;

private:
    std::vector<fs::path> m_files;
};

pid_t start(const std::vector<std::string> &arguments) {
    std::vector<char *> argv;
    argv.reserve(arguments.size() + 1);
    for (const std::string &argument : arguments)
        argv.push_back(const_cast<char *>(argument.c_str())); // NOLINT: what exec() asks for
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t process = -1;
    const int error = posix_spawn(&process, NORI_PROGRAM, &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0)
        throw GraderError(
            fmt::format("{}: cannot be started: {}", NORI_PROGRAM, std::strerror(error)));
    return process;
}

/// Waits for its end, and passes an interruption on: a terminal tells both, `kill` only us.
int waitFor(pid_t process, const std::atomic<bool> &interrupted) {
    int status = 0;
    bool told = false;
    while (::waitpid(process, &status, 0) < 0) {
        if (errno != EINTR)
            throw GraderError(fmt::format("waiting for nori: {}", std::strerror(errno)));
        if (interrupted && !told) {
            ::kill(process, SIGINT);
            told = true;
        }
    }
    return status;
}

} // namespace

RenderEnd runRenderer(const RenderJob &job, const std::atomic<bool> &interrupted) {
    fs::path stem = job.output;
    stem.replace_extension(fmt::format(".part-{}", ::getpid()));
    const fs::path exr = stem.string() + ".exr";
    const Leftovers leftovers({exr, stem.string() + ".png"});
    std::vector<std::string> arguments{"nori",     job.scene.string(),
                                       "--no-gui", "--moments",
                                       "--spp",    std::to_string(job.samplesPerPixel),
                                       "--seed",   std::to_string(job.seed),
                                       "--size",   fmt::format("{}x{}", job.width, job.height),
                                       "--output", exr.string()};
    if (!job.integrator.empty())
        arguments.insert(arguments.end(), {"--integrator", job.integrator});
    const int status = waitFor(start(arguments), interrupted);
    if (interrupted || (WIFEXITED(status) && WEXITSTATUS(status) == kInterruptedCode))
        return RenderEnd::Interrupted;
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        throw GraderError(fmt::format("{}: could not be rendered", job.scene.string()));
    fs::rename(exr, job.output);
    return RenderEnd::Done;
}

std::string rendererVersion() {
    return "nori " NORI_VERSION;
}

} // namespace grader
