// SPDX-License-Identifier: MIT
#include "guard.h"

#include <grader/sandbox/descriptor.h>
#include <grader/sandbox/orphans.h>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <memory>
#include <mutex>
#include <thread>

namespace grader {

namespace {

constexpr int kLeash = 3; ///< the guard's end of the pipe, and all that it keeps open

/// Waits for our end, which closes the other end of the pipe.
[[noreturn]] void guard(int leash) {
    ::setsid(); // what ends us from a terminal must not end it
    for (int signal = 1; signal < SIGRTMAX; ++signal)
        ::signal(signal, SIG_IGN);
    ::signal(SIGCHLD, SIG_DFL);
    // Whoever reads our output must not wait for it.
    if (::dup2(leash, kLeash) < 0)
        ::_exit(1);
    ::close_range(0, kLeash - 1, 0);
    ::close_range(kLeash + 1, ~0U, 0);
    char farewell = 0;
    ssize_t count = 0;
    while ((count = ::read(kLeash, &farewell, 1)) < 0 && errno == EINTR) {
    }
    // Our boxes end as the kernel comes to it; those that cannot appear meanwhile.
    for (int i = 0; count == 0 && i < 100; ++i) {
        killOrphans();
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    ::_exit(0);
}

/// The end of the pipe whose closing wakes the guard.
class Guarded {
public:
    Guarded() {
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0)
            return;
        const Descriptor leash(ends[0]);
        m_end = Descriptor(ends[1]);
        m_process = ::getpid();
        // The guard must be nobody's child here, or we would wait for it: forked twice, and not
        // adopted.
        int adopts = 0;
        ::prctl(PR_GET_CHILD_SUBREAPER, &adopts, 0, 0, 0);
        ::prctl(PR_SET_CHILD_SUBREAPER, 0, 0, 0, 0);
        const pid_t between = ::fork();
        if (between == 0) {
            m_end.close();
            if (::fork() == 0)
                guard(leash.get());
            ::_exit(0);
        }
        while (between > 0 && ::waitpid(between, nullptr, 0) < 0 && errno == EINTR) {
        }
        ::prctl(PR_SET_CHILD_SUBREAPER, adopts, 0, 0, 0);
    }

    ~Guarded() {
        const char farewell = 1;
        if (m_end && m_process == ::getpid() && ::write(m_end.get(), &farewell, 1) != 1)
            return; // it has gone already
    }

    Guarded(const Guarded &) = delete;
    Guarded &operator=(const Guarded &) = delete;
    Guarded(Guarded &&) = delete;
    Guarded &operator=(Guarded &&) = delete;

    pid_t process() const { return m_process; }

private:
    Descriptor m_end;
    pid_t m_process = 0;
};

} // namespace

void keepGuard() {
    static std::mutex mutex;
    static std::unique_ptr<Guarded> guarded;
    const std::lock_guard<std::mutex> lock(mutex);
    if (guarded == nullptr || guarded->process() != ::getpid()) // or forked from one that has one
        guarded = std::make_unique<Guarded>();
}

} // namespace grader
