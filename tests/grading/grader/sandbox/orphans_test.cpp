// SPDX-License-Identifier: MIT
#include <grader/sandbox/launch.h>
#include <grader/sandbox/orphans.h>
#include <grader/sandbox/seccomp_filter.h>
#include <grader/sandbox/supervisor.h>

#include <fcntl.h>

#include <csignal>
#include <future>
#include <thread>

#include "hostile_box.h"

namespace grader {

namespace {

using std::chrono::milliseconds;

class Orphans : public HostileBox {
protected:
    void SetUp() override {
        HostileBox::SetUp();
        m_program = place(HOSTILE);
        adoptOrphans(); // so that they can be waited for here
    }

    /// Starts a box that does not ask to die with its parent, as if that had been killed before it
    /// could. \return  bubblewrap
    pid_t startCareless() const {
        const Descriptor filter = seccompFilter(false);
        const Descriptor status(::open("/dev/null", O_WRONLY | O_CLOEXEC));
        constexpr int kStatusFd = 200;
        constexpr int kFilterFd = 201;
        std::vector<std::string> arguments =
            bubblewrapArguments(hostileSpec(m_program, "rest", m_marker), kStatusFd, kFilterFd);
        const auto care = std::find(arguments.begin(), arguments.end(), "--die-with-parent");
        EXPECT_NE(care, arguments.end());
        arguments.erase(care);
        std::vector<char *> argv;
        argv.reserve(arguments.size() + 1);
        for (std::string &argument : arguments)
            argv.push_back(argument.data());
        argv.push_back(nullptr);
        const pid_t process = ::fork();
        if (process == 0) {
            ::dup2(status.get(), kStatusFd);
            ::dup2(filter.get(), kFilterFd);
            ::execv(kBubblewrap, argv.data());
            ::_exit(1);
        }
        return process;
    }

    /// Waits for something; what has died and is ours leaves.
    template <typename Holds>
    static bool within(std::chrono::seconds patience, const Holds &holds) {
        const auto end = std::chrono::steady_clock::now() + patience;
        while (std::chrono::steady_clock::now() < end) {
            if (holds()) // perhaps for a moment only
                return true;
            std::this_thread::sleep_for(milliseconds(5));
            while (::waitpid(-1, nullptr, WNOHANG) > 0) {
            }
        }
        return false;
    }

    bool becomes(int processes, std::chrono::seconds patience = std::chrono::seconds(10)) const {
        return within(patience, [&] { return processesMarked(m_marker) == processes; });
    }

    static bool becomesChildless() {
        return within(std::chrono::seconds(10), [] { return !hasChild(); });
    }

    std::filesystem::path m_program;
};

TEST_F(Orphans, AreKilled) {
    const pid_t bubblewrap = startCareless();
    ASSERT_TRUE(becomes(3));
    ::kill(bubblewrap, SIGKILL);
    // What is left would rest for ever. (Any grader that starts on this machine may be quicker.)
    EXPECT_TRUE(within(std::chrono::seconds(10), [&] {
        killOrphans();
        return processesMarked(m_marker) == 0;
    }));
    EXPECT_TRUE(becomesChildless());
}

TEST_F(Orphans, AreNotLeftByAGraderThatIsKilledAsItStartsOne) {
    for (const SandboxLevel level : {SandboxLevel::S2, SandboxLevel::S3}) {
        const Sandbox sandbox(level);
        for (const int delay : {1, 10, 20, 30, 45}) { // `./run endurance` tries more
            const pid_t grader = ::fork();
            ASSERT_GE(grader, 0);
            if (grader == 0) {
                sandbox.run(hostileSpec(m_program, "rest", m_marker));
                ::_exit(0);
            }
            std::this_thread::sleep_for(milliseconds(delay));
            ::kill(grader, SIGKILL);
            // Nobody sweeps here but the guard of the killed one.
            EXPECT_TRUE(becomes(0)) << "after " << delay << " ms";
            EXPECT_TRUE(becomesChildless());
        }
    }
}

TEST_F(Orphans, AreNotTheBoxesOfGradersThatRun) {
    const Sandbox sandbox;
    BoxSpec resting = hostileSpec(m_program, "rest", m_marker);
    resting.limits.wall = milliseconds(500);
    const BoxSpec quick = hostileSpec(m_program, "exit_with_seven", m_marker);
    auto runs = std::async(std::launch::async, [&] {
        const BoxEnd end = sandbox.run(resting).end;
        EXPECT_TRUE(std::holds_alternative<BoxTimedOut>(end)) << describe(end);
        for (int i = 0; i < 50; ++i) {
            const BoxEnd quickEnd = sandbox.run(quick).end;
            const auto *exited = std::get_if<BoxExited>(&quickEnd);
            EXPECT_TRUE(exited != nullptr && exited->code == 7) << describe(quickEnd);
        }
    });
    while (runs.wait_for(milliseconds(1)) != std::future_status::ready)
        killOrphans();
}

} // namespace

} // namespace grader
