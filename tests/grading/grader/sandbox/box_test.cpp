// SPDX-License-Identifier: MIT
#include <grader/sandbox/descriptor.h>
#include <grader/sandbox/supervisor.h>

#include <fcntl.h>
#include <sys/mman.h>

#include <atomic>
#include <cstdlib>
#include <random>
#include <thread>

#include "hostile_box.h"

namespace grader {

namespace {

using std::chrono::milliseconds;

/// On the wall clock; the tests' machine may be busy.
bool ranOutOfTime(const BoxOutcome &outcome) {
    const auto *timedOut = std::get_if<BoxTimedOut>(&outcome.end);
    return (timedOut != nullptr && !timedOut->cpu) ||
           std::holds_alternative<BoxStarved>(outcome.end);
}

/// Everything is tried at both levels: what only control groups can hold is told apart.
class Box : public HostileBox, public ::testing::WithParamInterface<SandboxLevel> {
protected:
    static const Sandbox &sandbox() {
        static const Sandbox strong(SandboxLevel::S3);
        static const Sandbox weaker(SandboxLevel::S2);
        return GetParam() == SandboxLevel::S3 ? strong : weaker;
    }

    void SetUp() override {
        HostileBox::SetUp();
        m_program = place(HOSTILE);
        std::string findings;
        for (const std::string &line : sandbox().findings())
            findings += line + "\n";
        ASSERT_GE(sandbox().level(), SandboxLevel::S2) << findings;
        // An ordinary user's machine often has no control groups; one that tests for all must.
        if (sandbox().level() != GetParam() && std::getenv("CI") == nullptr)
            GTEST_SKIP() << findings;
        ASSERT_EQ(sandbox().level(), GetParam()) << findings;
    }

    BoxSpec spec(const std::string &mode) const { return hostileSpec(m_program, mode, m_marker); }

    /// For modes that use up their CPU time: on a busy machine that takes many times as long.
    BoxSpec spinning(const std::string &mode) const {
        BoxSpec spec = hostileSpec(m_program, mode, m_marker);
        spec.limits.wall = std::chrono::seconds(120);
        return spec;
    }

    static BoxOutcome run(const BoxSpec &spec) {
        BoxOutcome outcome = sandbox().run(spec);
        EXPECT_EQ(outcome.log.find("GOT"), std::string::npos) << outcome.log;
        return outcome;
    }

    /// For modes that come to their end.
    BoxOutcome tryMode(const std::string &mode) const {
        BoxOutcome outcome = run(spec(mode));
        EXPECT_TRUE(std::holds_alternative<BoxExited>(outcome.end)) << describe(outcome.end);
        EXPECT_NE(outcome.log.find("tried"), std::string::npos) << outcome.log;
        return outcome;
    }

    std::filesystem::path m_program;
};

/// The number after `key` in a log.
long numberAfter(const std::string &log, const std::string &key) {
    const std::size_t at = log.find(key + " ");
    return at == std::string::npos ? -1 : std::atol(log.c_str() + at + key.size());
}

/// The end that is asked for; fails if it was another.
template <typename End>
End endOf(const BoxOutcome &outcome) {
    const End *end = std::get_if<End>(&outcome.end);
    if (end != nullptr)
        return *end;
    ADD_FAILURE() << describe(outcome.end) << "; log: " << outcome.log.substr(0, 300);
    return {};
}

TEST(EndOfTime, IsTheMachinesFaultOnlyWhereTheBoxWaitedForIt) {
    const auto isStarved = [](double wall, double cpu, double waited) {
        return std::holds_alternative<BoxStarved>(endOfTime(wall, cpu, waited));
    };
    EXPECT_TRUE(isStarved(90, 10, 78)) << "seventeen others on two cores";
    EXPECT_FALSE(isStarved(90, 0.1, 0.2)) << "it slept";
    EXPECT_FALSE(isStarved(90, 88, 1)) << "it computed";
    EXPECT_FALSE(isStarved(90, 178, 84)) << "32 processes of its own on two cores";
    EXPECT_FALSE(isStarved(90, 0, 0)) << "the kernel does not count";
}

TEST_P(Box, TellsTheExitCode) {
    const BoxOutcome outcome = run(spec("exit_with_seven"));
    EXPECT_EQ(endOf<BoxExited>(outcome).code, 7);
    EXPECT_EQ(outcome.log, "PASSED\n");
}

TEST_P(Box, TellsTheSignal) {
    EXPECT_EQ(endOf<BoxSignalled>(run(spec("crash"))).signal, SIGSEGV);
}

TEST_P(Box, TellsExitCodesThatOnlyLookLikeSignals) {
    EXPECT_EQ(endOf<BoxExited>(run(spec("exit_with_minus_one"))).code, 255);
}

TEST_P(Box, EndsAProgramThatSpins) {
    const BoxOutcome outcome = run(spinning("spin"));
    EXPECT_TRUE(endOf<BoxTimedOut>(outcome).cpu);
    EXPECT_NEAR(outcome.cpuSeconds, 1, 0.3);
}

TEST_P(Box, EndsAProgramThatIgnoresTheCpuSignal) {
    EXPECT_TRUE(endOf<BoxTimedOut>(run(spinning("ignore_cpu_signal"))).cpu);
}

TEST_P(Box, CountsTheCpuTimeOfAProgramThatItKills) {
    BoxSpec killed = spec("spin");
    killed.limits.wall = milliseconds(600);
    const BoxOutcome outcome = run(killed);
    EXPECT_TRUE(ranOutOfTime(outcome)) << describe(outcome.end);
    EXPECT_GT(outcome.cpuSeconds, 0.05); // the machine may be busy
    EXPECT_LT(outcome.cpuSeconds, 0.8);
}

TEST_P(Box, EndsProgramsThatRestOrStop) {
    for (const char *mode : {"rest", "stop_self"}) {
        BoxSpec resting = spec(mode);
        resting.limits.wall = milliseconds(300);
        const BoxOutcome outcome = run(resting);
        EXPECT_TRUE(ranOutOfTime(outcome)) << describe(outcome.end);
        EXPECT_LT(outcome.wallSeconds, 3);
    }
}

TEST_P(Box, RefusesAProbeToFork) {
    const BoxOutcome outcome = tryMode("fork");
    EXPECT_EQ(numberAfter(outcome.log, "children"), 0);
    tryMode("fork_otherwise");
}

TEST_P(Box, LetsACompilerForkUpToItsLimit) {
    BoxSpec forking = spec("fork_and_rest");
    forking.mayFork = true;
    forking.limits.wall = milliseconds(1500);
    const BoxOutcome outcome = run(forking);
    EXPECT_TRUE(ranOutOfTime(outcome)) << describe(outcome.end);
    const long children = numberAfter(outcome.log, "children");
    EXPECT_GE(children, 8) << outcome.log;
    EXPECT_LE(children, 26) << outcome.log;
}

TEST_P(Box, TakesNoProcessesFromOtherBoxes) {
    BoxSpec greedy = spec("fork_and_rest");
    greedy.mayFork = true;
    greedy.limits.wall = std::chrono::seconds(2);
    std::thread first([&] { EXPECT_TRUE(ranOutOfTime(run(greedy))); });
    std::this_thread::sleep_for(std::chrono::seconds(1));
    BoxSpec second = spec("fork_and_rest");
    second.mayFork = true;
    second.limits.wall = milliseconds(1500);
    EXPECT_GE(numberAfter(run(second).log, "children"), 8);
    first.join();
}

TEST_P(Box, BoundsThreads) {
    const BoxOutcome outcome = run(spec("start_threads"));
    const long threads = numberAfter(outcome.log, "threads");
    EXPECT_GE(threads, 8) << outcome.log;
    EXPECT_LE(threads, 26) << outcome.log;
}

TEST_P(Box, BoundsMemory) {
    const BoxOutcome outcome = run(spec("eat_memory"));
    if (GetParam() == SandboxLevel::S3) {
        endOf<BoxOutOfMemory>(outcome);
    } else {
        endOf<BoxExited>(outcome);
        const long mebibytes = numberAfter(outcome.log, "mebibytes");
        EXPECT_GT(mebibytes, 64);
        EXPECT_LE(mebibytes, 128);
    }
}

TEST_P(Box, RefusesMemoryThatCountsAsNobodys) {
    tryMode("park_memory");
}

TEST_P(Box, BoundsFilesAndFolders) {
    BoxSpec filling = spec("fill_folders");
    filling.limits.cpu = std::chrono::seconds(5);
    const BoxOutcome outcome = run(filling);
    EXPECT_LE(numberAfter(outcome.log, "/dev/shm"), 1 << 20);
    const long temporary = numberAfter(outcome.log, "/tmp");
    EXPECT_GE(temporary, 15 << 20) << outcome.log;
    EXPECT_LE(temporary, 16 << 20);
    EXPECT_EQ(numberAfter(tryMode("write_large_file").log, "blocks"), 8);
}

TEST_P(Box, EndsAProgramThatFloodsTheLog) {
    const BoxOutcome outcome = run(spec("flood_log"));
    endOf<BoxLogTooLarge>(outcome);
    EXPECT_EQ(outcome.log.size(), std::size_t{1} << 20);
}

TEST_P(Box, KeepsTheWholeLogOfAProgramThatEndsAtOnce) {
    const BoxOutcome outcome = tryMode("print_much");
    EXPECT_EQ(outcome.log.size(), 300u * 1001 + 6);
}

TEST_P(Box, NeverReturnsMoreLogThanItsLimit) {
    BoxSpec printing = spec("print_much");
    printing.limits.logBytes = 290'000;
    EXPECT_LE(run(printing).log.size(), 290'000u);
}

TEST_P(Box, HasNobodyElseToKill) {
    const BoxOutcome outcome = tryMode("kill_all");
    EXPECT_LT(outcome.wallSeconds, 5);
}

TEST_P(Box, HasNoNetwork) {
    tryMode("connect_out");
}

TEST_P(Box, RefusesDangerousCalls) {
    tryMode("attack_kernel");
}

TEST_P(Box, RefusesDangerousCallsToCompilersToo) {
    BoxSpec compiler = spec("attack_kernel");
    compiler.mayFork = true;
    EXPECT_NE(run(compiler).log.find("tried"), std::string::npos);
}

TEST_P(Box, KnowsNoCallsOfOtherMachines) {
    const BoxOutcome outcome = run(spec("call_other_machines"));
    EXPECT_EQ(endOf<BoxSignalled>(outcome).signal, SIGSYS);
}

TEST_P(Box, IsNotToldAnotherEndByAnAttackOnItsFirstProcess) {
    EXPECT_EQ(endOf<BoxExited>(tryMode("attack_first_process")).code, 0);
}

TEST_P(Box, ShowsNothingOfTheHost) {
    const BoxOutcome outcome = tryMode("look_around");
    EXPECT_NE(outcome.log.find("uid 65534 gid 65534 session without terminal"), std::string::npos)
        << outcome.log;
    std::istringstream words(outcome.log);
    const std::vector<std::string> allowed = {".",     "..",  "bin", "dev",     "lib",
                                              "lib64", "tmp", "usr", "hostile", "sentinel"};
    for (std::string word; words >> word;) {
        if (word == "root" && words >> word) {
            EXPECT_NE(std::find(allowed.begin(), allowed.end(), word), allowed.end()) << word;
        }
        if (word == "environment" && words >> word) {
            EXPECT_TRUE(word.rfind("LANG=", 0) == 0 || word == "PWD=/tmp" ||
                        word == "TMPDIR=/tmp" || word == "PATH=/usr/bin")
                << word;
        }
    }
}

TEST_P(Box, LetsNothingOfTheHostBeWritten) {
    tryMode("write_host");
}

TEST_P(Box, PassesExactlyTheAgreedDescriptors) {
    EXPECT_EQ(tryMode("list_descriptors").log, "descriptor 0\ndescriptor 1\ndescriptor 2\ntried\n");
}

TEST_P(Box, PassesTheRightDescriptorsWhenManyAreOpen) {
    std::vector<Descriptor> files;
    for (int i = 0; i < 150; ++i) {
        files.emplace_back(::memfd_create("file", MFD_CLOEXEC));
        const std::string text = std::to_string(i) + ";";
        ASSERT_EQ(::write(files.back().get(), text.data(), text.size()),
                  static_cast<ssize_t>(text.size()));
    }
    BoxSpec reading = spec("read_descriptors");
    reading.descriptors = {files[96].get(), files[3].get(), files[149].get()};
    EXPECT_EQ(run(reading).log, "3 holds 96;\n4 holds 3;\n5 holds 149;\ntried\n");
}

TEST_P(Box, LeavesNoDaemonBehind) {
    BoxSpec daemon = spec("daemonise");
    daemon.mayFork = true;
    const BoxOutcome outcome = run(daemon);
    endOf<BoxExited>(outcome);
    // Seen at once, without waiting for anything: the promise of run().
    EXPECT_EQ(processesMarked(m_marker), 0);
    EXPECT_LT(outcome.wallSeconds, 5); // although the daemon holds the log open
}

TEST_P(Box, BlamesNobodyForABindThatIsNotThere) {
    BoxSpec missing = spec("exit_with_seven");
    missing.binds.push_back({m_folder / "missing", "/missing", false});
    EXPECT_NE(endOf<BoxNotStarted>(sandbox().run(missing)).reason.find("missing"),
              std::string::npos);
}

TEST_P(Box, SaysThatAFolderCannotBeSearched) {
    if (::geteuid() != 0)
        return; // an ordinary user's boxes see what the user sees
    const std::filesystem::path hidden = m_folder / "hidden";
    std::filesystem::create_directory(hidden);
    ::chmod(hidden.c_str(), 0700);
    std::ofstream(hidden / "file") << "text";
    BoxSpec secret = spec("exit_with_seven");
    secret.binds.push_back({hidden / "file", "/file", false});
    EXPECT_NE(endOf<BoxNotStarted>(sandbox().run(secret)).reason.find("searchable"),
              std::string::npos);
}

TEST_P(Box, BlamesNobodyForAProgramThatIsNotThere) {
    BoxSpec missing = spec("exit_with_seven");
    missing.argv = {"/missing"};
    endOf<BoxNotStarted>(sandbox().run(missing));
}

TEST_P(Box, RunsManyAtATimeWithoutLeaks) {
    constexpr int kThreads = 8;
    constexpr int kRuns = 25;
    const BoxSpec quick = spec("exit_with_seven");
    run(quick);
    const long before = openDescriptors();
    std::atomic<int> good{0};
    std::vector<std::thread> threads;
    threads.reserve(kThreads);
    for (int i = 0; i < kThreads; ++i) {
        threads.emplace_back([&] {
            for (int k = 0; k < kRuns; ++k) {
                const BoxOutcome outcome = sandbox().run(quick);
                const auto *exited = std::get_if<BoxExited>(&outcome.end);
                if (exited != nullptr && exited->code == 7 && outcome.log == "PASSED\n")
                    ++good;
                else
                    ADD_FAILURE() << describe(outcome.end) << ": " << outcome.log;
            }
        });
    }
    for (std::thread &thread : threads)
        thread.join();
    EXPECT_EQ(good, kThreads * kRuns);
    EXPECT_EQ(openDescriptors(), before);
}

TEST_P(Box, LeavesNothingWhenKilledAtAnyMoment) {
    std::mt19937 random(1);
    for (int i = 0; i < 60; ++i) {
        BoxSpec resting = spec("rest");
        resting.limits.wall = milliseconds(random() % 40);
        run(resting);
        ASSERT_EQ(processesMarked(m_marker), 0) << "after " << resting.limits.wall.count() << " ms";
    }
}

INSTANTIATE_TEST_SUITE_P(Levels, Box, ::testing::Values(SandboxLevel::S2, SandboxLevel::S3),
                         [](const auto &parameter) { return sandboxLevelName(parameter.param); });

} // namespace

} // namespace grader
