// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace nori::test {

inline std::string readAll(int descriptor) {
    std::string text;
    char buffer[4096];
    for (ssize_t count = 0; (count = ::read(descriptor, buffer, sizeof buffer)) > 0;)
        text.append(buffer, static_cast<std::size_t>(count));
    return text;
}

/// What a run of the program left.
struct Outcome {
    int code = -1; ///< exit code; -1 if a signal ended it
    std::string output;
    std::string errors;
};

/// `nori` with these arguments, running in `folder`.
class Program {
public:
    Program(const std::filesystem::path &folder, const std::vector<std::string> &arguments,
            rlim_t largestFile = RLIM_INFINITY) {
        int out[2] = {};
        int err[2] = {};
        if (::pipe(out) != 0 || ::pipe(err) != 0)
            throw std::runtime_error("pipe() failed");
        m_pid = ::fork();
        if (m_pid == 0) {
            ::dup2(out[1], STDOUT_FILENO);
            ::dup2(err[1], STDERR_FILENO);
            for (const int descriptor : {out[0], out[1], err[0], err[1]})
                ::close(descriptor);
            const rlimit limit{largestFile, largestFile};
            ::setrlimit(RLIMIT_FSIZE, &limit);
            std::vector<char *> argv{const_cast<char *>("nori")};
            for (const std::string &argument : arguments)
                argv.push_back(const_cast<char *>(argument.c_str()));
            argv.push_back(nullptr);
            if (::chdir(folder.c_str()) == 0)
                ::execv(NORI_PROGRAM, argv.data());
            ::_exit(127);
        }
        ::close(out[1]);
        ::close(err[1]);
        m_out = out[0];
        m_err = err[0];
    }

    ~Program() {
        ::close(m_out);
        ::close(m_err);
    }

    Program(const Program &) = delete;
    Program &operator=(const Program &) = delete;
    Program(Program &&) = delete;
    Program &operator=(Program &&) = delete;

    /// Waits until it has said something on stderr.
    void waitForWarning() const {
        char first = 0;
        ASSERT_EQ(::read(m_err, &first, 1), 1);
    }

    void signal(int number) const { ::kill(m_pid, number); }

    /// Waits for the end.
    Outcome finish() const {
        Outcome outcome;
        outcome.output = readAll(m_out);
        outcome.errors = readAll(m_err);
        int status = 0;
        ::waitpid(m_pid, &status, 0);
        if (WIFEXITED(status))
            outcome.code = WEXITSTATUS(status);
        return outcome;
    }

private:
    pid_t m_pid = 0;
    int m_out = -1;
    int m_err = -1;
};

} // namespace nori::test
