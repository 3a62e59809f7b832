// SPDX-License-Identifier: MIT
#include <grader/error.h>

#include <fcntl.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <limits>

#include "hostile_box.h"

namespace grader {

namespace {

class ControlGroup : public ::testing::Test {
protected:
    void SetUp() override {
        m_places = findCgroupPlaces();
        // An ordinary user's machine often has none; one that tests for all must.
        if (!m_places.complete() && std::getenv("CI") == nullptr)
            GTEST_SKIP() << "no control groups can be made here";
        ASSERT_TRUE(m_places.complete());
    }

    void TearDown() override { EXPECT_EQ(controlGroupsOf(::getpid()), 0); }

    /// One folder for each place: version 2 has one place for everything.
    int folders() const { return m_places.version2 ? 1 : 2; }

    CgroupPlaces m_places;
};

TEST_F(ControlGroup, IsThereForAsLongAsItsObject) {
    {
        const Cgroup first(m_places, {});
        const Cgroup second(m_places, {});
        EXPECT_GE(controlGroupsOf(::getpid()), 2 * folders());
    }
    EXPECT_EQ(controlGroupsOf(::getpid()), 0);
}

TEST_F(ControlGroup, KillsWhatIsInIt) {
    Cgroup group(m_places, {});
    const std::vector<Descriptor> entrances = group.entrances();
    std::array<int, 2> entered{};
    ASSERT_EQ(::pipe2(entered.data(), O_CLOEXEC), 0);
    const Descriptor read(entered[0]);
    Descriptor write(entered[1]);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        for (const Descriptor &entrance : entrances) {
            if (::write(entrance.get(), "0", 1) != 1)
                ::_exit(1);
        }
        write.close();
        for (;;)
            ::pause();
    }
    write.close();
    char none = 0;
    ASSERT_EQ(::read(read.get(), &none, 1), 0); // the child has entered, or is dead
    // Its dead members leave it before anyone has waited for them.
    group.killAll();
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
    EXPECT_FALSE(group.ranOutOfMemory());
}

TEST_F(ControlGroup, WithALimitThatTheKernelRefusesIsNone) {
    BoxLimits limits;
    limits.processes = std::numeric_limits<std::uint32_t>::max() - 10;
    EXPECT_THROW(Cgroup(m_places, limits), GraderError);
    EXPECT_EQ(controlGroupsOf(::getpid()), 0);
}

TEST_F(ControlGroup, OfAGraderThatWasKilledIsRemovedByTheNext) {
    const pid_t killed = ::fork();
    ASSERT_GE(killed, 0);
    if (killed == 0) {
        const Cgroup group(m_places, {});
        ::raise(SIGKILL);
    }
    // Until it is waited for it counts as there, and no other grader on this machine is quicker.
    siginfo_t info{};
    ASSERT_EQ(::waitid(P_PID, static_cast<id_t>(killed), &info, WEXITED | WNOWAIT), 0);
    EXPECT_GE(controlGroupsOf(killed), folders());
    ::waitpid(killed, nullptr, 0);
    findCgroupPlaces();
    EXPECT_EQ(controlGroupsOf(killed), 0);
}

} // namespace

} // namespace grader
