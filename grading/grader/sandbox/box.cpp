// SPDX-License-Identifier: MIT
#include "box.h"

#include <grader/error.h>
#include <grader/sandbox/cgroup.h>
#include <grader/sandbox/launch.h>

#include <fmt/core.h>

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <optional>

namespace grader {

namespace {

using Clock = std::chrono::steady_clock;

/// bubblewrap says on its status descriptor which process is the first of the new namespace. With
/// that one, everything in the box dies; killing bubblewrap itself can leave it alive (its #633).
int firstProcess(const std::string &status) {
    const std::string key = "\"child-pid\": ";
    const std::size_t at = status.find(key);
    return at == std::string::npos ? -1 : std::atoi(status.c_str() + at + key.size());
}

bool hasExited(const std::string &status) {
    return status.find("\"exit-code\"") != std::string::npos;
}

/// Follows one box to its end.
class Supervisor {
public:
    Supervisor(const BoxSpec &spec, Launched launched)
        : m_spec(spec), m_launched(std::move(launched)) {}

    ~Supervisor() { kill(); }

    Supervisor(const Supervisor &) = delete;
    Supervisor &operator=(const Supervisor &) = delete;

    BoxOutcome run(Cgroup *cgroup) {
        const Clock::time_point start = Clock::now();
        const Clock::time_point deadline = start + m_spec.limits.wall;
        while (!m_logEnd || !m_statusEnd) {
            const auto left =
                std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
            if (left.count() <= 0) {
                m_early = BoxTimedOut{false};
                break;
            }
            readSome(static_cast<int>(left.count()));
            if (m_log.size() > m_spec.limits.logBytes) {
                m_log.resize(m_spec.limits.logBytes);
                m_early = BoxLogTooLarge{};
                break;
            }
            // Something may hold the log open after the program's end: it is not waited for.
            if (hasExited(m_status))
                break;
        }
        readSome(0);
        kill();
        const bool outOfMemory = cgroup != nullptr && cgroup->ranOutOfMemory();
        if (cgroup != nullptr)
            cgroup->killAll();

        BoxOutcome outcome;
        outcome.wallSeconds = std::chrono::duration<double>(Clock::now() - start).count();
        outcome.cpuSeconds = m_cpuSeconds;
        outcome.end = end(outOfMemory);
        outcome.log = std::move(m_log);
        return outcome;
    }

private:
    void readSome(int timeout) {
        std::array<pollfd, 2> waits = {{{m_logEnd ? -1 : m_launched.log.get(), POLLIN, 0},
                                        {m_statusEnd ? -1 : m_launched.status.get(), POLLIN, 0}}};
        if (::poll(waits.data(), waits.size(), timeout) <= 0)
            return;
        if (waits[0].revents != 0)
            m_logEnd = !readInto(m_launched.log.get(), m_log);
        if (waits[1].revents != 0) {
            m_statusEnd = !readInto(m_launched.status.get(), m_status);
            const int first = firstProcess(m_status);
            if (!m_first && first > 0)
                m_first = Descriptor(static_cast<int>(::syscall(SYS_pidfd_open, first, 0)));
        }
    }

    /// \return  false at the end
    static bool readInto(int fd, std::string &text) {
        std::array<char, 65536> buffer{};
        const ssize_t count = ::read(fd, buffer.data(), buffer.size());
        if (count > 0)
            text.append(buffer.data(), static_cast<std::size_t>(count));
        return count > 0 || (count < 0 && errno == EINTR);
    }

    void kill() {
        if (m_launched.process <= 0)
            return;
        if (m_first)
            ::syscall(SYS_pidfd_send_signal, m_first.get(), SIGKILL, nullptr, 0);
        // With its child gone bubblewrap ends by itself; before it has one, it is killed.
        if (!m_first)
            ::kill(m_launched.process, SIGKILL);
        rusage usage{};
        while (::wait4(m_launched.process, &m_waitStatus, 0, &usage) < 0 && errno == EINTR) {
        }
        const auto seconds = [](const timeval &time) {
            return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
        };
        m_cpuSeconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
        m_launched.process = -1;
    }

    BoxEnd end(bool outOfMemory) const {
        constexpr int kSignalOffset = 128; // bubblewrap, like shells, adds it to a signal's number
        if (m_early)
            return *m_early;
        if (!m_first)
            return BoxNotStarted{m_log.empty() ? "bubblewrap ended without a word" : m_log};
        if (outOfMemory)
            return BoxOutOfMemory{};
        const std::string key = "\"exit-code\": ";
        const std::size_t at = m_status.find(key);
        const int code = at == std::string::npos ? kSignalOffset + SIGKILL
                                                 : std::atoi(m_status.c_str() + at + key.size());
        if (code <= kSignalOffset)
            return BoxExited{code};
        const int signal = code - kSignalOffset;
        const bool usedUp =
            m_cpuSeconds >= 0.9 * std::chrono::duration<double>(m_spec.limits.cpu).count();
        if (signal == SIGXCPU || (signal == SIGKILL && usedUp))
            return BoxTimedOut{true};
        return BoxSignalled{signal};
    }

    const BoxSpec &m_spec;
    Launched m_launched;
    Descriptor m_first; ///< pidfd of the namespace's first process
    std::string m_log;
    std::string m_status;
    bool m_logEnd = false;
    bool m_statusEnd = false;
    std::optional<BoxEnd> m_early;
    int m_waitStatus = 0;
    double m_cpuSeconds = 0;
};

} // namespace

const char *sandboxLevelName(SandboxLevel level) {
    constexpr const char *kNames[] = {"S0", "S1", "S2", "S3"};
    return kNames[static_cast<int>(level)];
}

std::string describe(const BoxEnd &end) {
    struct Describe {
        std::string operator()(const BoxExited &exited) const {
            return fmt::format("it exited with code {}", exited.code);
        }

        std::string operator()(const BoxSignalled &signalled) const {
            return fmt::format("it was ended by signal {} ({})", signalled.signal,
                               ::strsignal(signalled.signal));
        }

        std::string operator()(const BoxTimedOut &timedOut) const {
            return timedOut.cpu ? "it used up its CPU time" : "it used up its time";
        }

        std::string operator()(const BoxOutOfMemory &) const { return "it used up its memory"; }

        std::string operator()(const BoxLogTooLarge &) const { return "it printed too much"; }

        std::string operator()(const BoxNotStarted &notStarted) const {
            return "it could not be started: " + notStarted.reason;
        }
    };

    return std::visit(Describe(), end);
}

BoxOutcome Sandbox::run(const BoxSpec &spec) const {
    if (m_level < SandboxLevel::S2)
        throw GraderError("this machine cannot lock submissions in, so none is run; `norigrade "
                          "doctor` says what is missing");
    std::optional<Cgroup> cgroup;
    if (m_level == SandboxLevel::S3)
        cgroup.emplace(m_cgroups, spec.limits);
    Launched launched = launch(spec, cgroup ? &*cgroup : nullptr);
    return Supervisor(spec, std::move(launched)).run(cgroup ? &*cgroup : nullptr);
}

} // namespace grader
