// SPDX-License-Identifier: MIT
#include "supervisor.h"

#include <grader/sandbox/cgroup.h>

#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <vector>

namespace grader {

namespace {

constexpr int kUnknown = -1;
constexpr char kFirstProcess[] = "\"child-pid\": ";
constexpr char kExitCode[] = "\"exit-code\": ";

/// bubblewrap tells its status as JSON, one object a line.
int numberAfter(const std::string &key, const std::string &status) {
    const std::size_t at = status.find(key);
    return at == std::string::npos ? kUnknown : std::atoi(status.c_str() + at + key.size());
}

/// \return  false at the end
bool readInto(int fd, std::string &text) {
    std::array<char, 65536> buffer{}; // a pipe's size: one call empties it
    const ssize_t count = ::read(fd, buffer.data(), buffer.size());
    if (count > 0)
        text.append(buffer.data(), static_cast<std::size_t>(count));
    return count > 0 || (count < 0 && errno == EINTR);
}

double seconds(const rusage &usage) {
    const auto of = [](const timeval &time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return of(usage.ru_utime) + of(usage.ru_stime);
}

/// All that descends from a process, as it runs.
std::vector<pid_t> descendantsOf(pid_t process) {
    const std::string name = std::to_string(process);
    std::ifstream children("/proc/" + name + "/task/" + name + "/children");
    std::vector<pid_t> all;
    for (pid_t child = 0; children >> child;) {
        all.push_back(child);
        const std::vector<pid_t> below = descendantsOf(child);
        all.insert(all.end(), below.begin(), below.end());
    }
    return all;
}

double cpuSeconds(const std::vector<pid_t> &processes) {
    double sum = 0;
    for (const pid_t process : processes) {
        clockid_t clock{};
        timespec time{};
        if (::clock_getcpuclockid(process, &clock) == 0 && ::clock_gettime(clock, &time) == 0)
            sum += static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    }
    return sum;
}

/// Seconds that the thread which waited most could have run and had no processor; 0 where the
/// kernel does not count them (proc(5), schedstat).
double longestWait(const std::vector<pid_t> &processes) {
    double longest = 0;
    for (const pid_t process : processes) {
        std::error_code error;
        const std::string tasks = "/proc/" + std::to_string(process) + "/task";
        for (const auto &task : std::filesystem::directory_iterator(tasks, error)) {
            std::ifstream file(task.path() / "schedstat");
            double running = 0;
            double waiting = 0;
            if (file >> running >> waiting)
                longest = std::max(longest, 1e-9 * waiting);
        }
    }
    return longest;
}

std::string startError(std::string log) {
    while (!log.empty() && log.back() == '\n')
        log.pop_back();
    if (log.empty())
        return "bubblewrap ended without a word";
    if (log.find("Permission denied") != std::string::npos)
        log += "; submissions run as a user without rights, so every folder on that path must be "
               "searchable for all (chmod o+x)";
    return log;
}

} // namespace

BoxEnd endOfTime(double wall, double cpu, double waited) {
    if (waited > 0.5 * wall && cpu < 0.5 * wall)
        return BoxStarved{waited};
    return BoxTimedOut{false};
}

void adoptOrphans() {
    ::prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0);
}

void Supervisor::readSome(Clock::duration timeout) {
    using std::chrono::milliseconds;
    const auto left = std::chrono::ceil<milliseconds>(timeout);
    std::array<pollfd, 2> waits = {{{m_logEnd ? -1 : m_launched.log.get(), POLLIN, 0},
                                    {m_statusEnd ? -1 : m_launched.status.get(), POLLIN, 0}}};
    if (::poll(waits.data(), waits.size(),
               static_cast<int>(std::max(left, milliseconds(0)).count())) <= 0)
        return;
    if (waits[0].revents != 0)
        m_logEnd = !readInto(m_launched.log.get(), m_log);
    if (waits[1].revents == 0)
        return;
    m_statusEnd = !readInto(m_launched.status.get(), m_status);
    const int first = numberAfter(kFirstProcess, m_status);
    if (!m_named && first > 0) {
        m_named = true;
        m_first = Descriptor(static_cast<int>(::syscall(SYS_pidfd_open, first, 0)));
    }
}

void Supervisor::follow(Clock::time_point deadline) {
    // Something may hold the log open after the program's end: it is not waited for.
    while ((!m_logEnd || !m_statusEnd) && exitCode() == kUnknown) {
        if (Clock::now() >= deadline) {
            m_early = BoxTimedOut{false};
            return;
        }
        readSome(deadline - Clock::now());
        if (m_log.size() > m_spec.limits.logBytes) {
            m_early = BoxLogTooLarge{};
            return;
        }
    }
    readSome(Clock::duration::zero()); // what it printed last
}

BoxOutcome Supervisor::run() {
    const Clock::time_point start = Clock::now();
    follow(start + m_spec.limits.wall);
    endAll();
    const bool outOfMemory = m_cgroup != nullptr && m_cgroup->ranOutOfMemory();

    BoxOutcome outcome;
    outcome.wallSeconds = std::chrono::duration<double>(Clock::now() - start).count();
    outcome.cpuSeconds = m_cpuSeconds;
    outcome.end = end(outOfMemory);
    m_log.resize(std::min<std::size_t>(m_log.size(), m_spec.limits.logBytes));
    outcome.log = std::move(m_log);
    return outcome;
}

void Supervisor::endAll() {
    if (m_launched.process <= 0)
        return;
    // With the first process of the namespace everything in the box dies. bubblewrap must not be
    // killed in its place: until that process has asked to die with it, it would live on (its
    // #633). So we wait until we are told which it is, a matter of milliseconds.
    const Clock::time_point patience = Clock::now() + std::chrono::seconds(10);
    while (!m_named && !m_statusEnd && Clock::now() < patience)
        readSome(patience - Clock::now());
    // Nobody is told the CPU time of what dies with its namespace: it is read before.
    std::vector<pid_t> processes;
    if (m_first && exitCode() == kUnknown)
        processes = descendantsOf(numberAfter(kFirstProcess, m_status));
    const double running = cpuSeconds(processes);
    m_waited = longestWait(processes);
    if (m_first)
        ::syscall(SYS_pidfd_send_signal, m_first.get(), SIGKILL, nullptr, 0);
    else if (!m_named)
        ::kill(m_launched.process, SIGKILL);

    rusage usage{};
    while (::wait4(m_launched.process, nullptr, 0, &usage) < 0 && errno == EINTR) {
    }
    m_launched.process = kUnknown;
    m_cpuSeconds = running + seconds(usage);
    // bubblewrap often ends before the first process, which then is our child, with the CPU time of
    // the box. It ends only after all others in the namespace. (The C library's waitid() hides the
    // last argument.)
    if (m_first) {
        siginfo_t info{};
        usage = {};
        while (::syscall(SYS_waitid, P_PIDFD, m_first.get(), &info, WEXITED, &usage) < 0 &&
               errno == EINTR) {
        }
        m_cpuSeconds += seconds(usage);
    }
    if (m_cgroup != nullptr)
        m_cgroup->killAll();
}

int Supervisor::exitCode() const {
    return numberAfter(kExitCode, m_status);
}

BoxEnd Supervisor::end(bool outOfMemory) const {
    constexpr int kSignalOffset = 128; // bubblewrap, like shells, adds it to a signal's number
    if (m_early && m_named) {
        if (std::holds_alternative<BoxTimedOut>(*m_early))
            return endOfTime(std::chrono::duration<double>(m_spec.limits.wall).count(),
                             m_cpuSeconds, m_waited);
        return *m_early;
    }
    if (outOfMemory)
        return BoxOutOfMemory{};
    // bubblewrap tells an exit code only if it got as far as starting the program.
    const int code = exitCode();
    if (code == kUnknown)
        return BoxNotStarted{startError(m_log)};
    const int signal = code - kSignalOffset;
    if (signal <= 0 || signal > SIGRTMAX) // exit(-1) gives 255, which is no signal's
        return BoxExited{code};
    const bool usedUp =
        m_cpuSeconds >= 0.9 * std::chrono::duration<double>(m_spec.limits.cpu).count();
    if (signal == SIGXCPU || (signal == SIGKILL && usedUp))
        return BoxTimedOut{true};
    return BoxSignalled{signal};
}

} // namespace grader
