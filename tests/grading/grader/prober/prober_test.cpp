// SPDX-License-Identifier: MIT
#include <grader/prober/prober.h>

#include <cmath>

#include "../sandbox/hostile_box.h"

namespace grader {

namespace {

using protocol::State;

constexpr std::chrono::milliseconds kSoon(1500); // a busy machine takes 0.3 s to start a box

class Prober : public HostileBox {
protected:
    static const Sandbox &sandbox() {
        static const Sandbox machine;
        return machine;
    }

    void SetUp() override {
        HostileBox::SetUp();
        m_probe = place(HOSTILE_PROBE);
    }

    /// Asks two questions of a probe that behaves like `mode`.
    /// \param wall  short for modes that do not end
    ProbeAnswer ask(const std::string &mode,
                    std::chrono::milliseconds wall = std::chrono::seconds(20)) const {
        protocol::RequestGroup group;
        group.files = {{mode, ""}};
        for (const float u : {0.25f, 0.5f}) {
            protocol::Request request;
            request.text = "triangle";
            request.values = {u, 0.125f, u, 0.375f};
            group.requests.push_back(request);
        }
        BoxLimits limits;
        limits.cpu = std::chrono::seconds(1);
        limits.wall = wall;
        ProbeAnswer answer = askProbe(sandbox(), m_probe, group, limits);
        EXPECT_EQ(answer.outcome.log.find("GOT"), std::string::npos) << answer.outcome.log;
        EXPECT_EQ(answer.responses.size(), 2u);
        return answer;
    }

    static void expectRight(const protocol::Response &response, float u) {
        EXPECT_EQ(response.state, State::Done);
        EXPECT_EQ(response.values, (std::vector<float>{2 * u, 0.25f, 2 * u, 0.75f}));
    }

    std::filesystem::path m_probe;
};

TEST_F(Prober, ReturnsEveryAnswer) {
    const ProbeAnswer answer = ask("answers_all");
    EXPECT_TRUE(answer.complete()) << describe(answer.outcome.end);
    expectRight(answer.responses[0], 0.25f);
    expectRight(answer.responses[1], 0.5f);
}

TEST_F(Prober, KeepsTheAnswersBeforeAnEarlyEnd) {
    const ProbeAnswer answer = ask("answers_first");
    EXPECT_FALSE(answer.complete());
    expectRight(answer.responses[0], 0.25f);
    EXPECT_EQ(answer.responses[1].state, State::Pending);
    EXPECT_TRUE(answer.responses[1].values.empty());
}

TEST_F(Prober, KeepsTheAnswersOfAProbeThatDoesNotEnd) {
    const ProbeAnswer answer = ask("answers_and_rests", kSoon);
    EXPECT_TRUE(std::holds_alternative<BoxTimedOut>(answer.outcome.end));
    EXPECT_TRUE(answer.complete());
}

TEST_F(Prober, ReadsOneOfTheAnswersOfAProbeThatKeepsChangingThem) {
    const protocol::Response response = ask("keeps_changing", kSoon).responses[0];
    if (response.state == State::Done) { // may have been caught between two
        for (const float value : response.values)
            EXPECT_TRUE(std::isfinite(value));
    }
}

TEST_F(Prober, TakesNoClaimForAnAnswer) {
    for (const char *mode : {"claims_to_have_passed", "spins"}) {
        const ProbeAnswer answer = ask(mode, kSoon);
        EXPECT_FALSE(answer.complete()) << mode;
        for (const protocol::Response &response : answer.responses)
            EXPECT_EQ(response.state, State::Pending) << mode;
    }
}

TEST_F(Prober, ReadsWhatWasNeverWrittenAsNoNumber) {
    for (const protocol::Response &response : ask("claims_to_be_done").responses) {
        ASSERT_EQ(response.values.size(), 4u);
        for (const float value : response.values)
            EXPECT_TRUE(std::isnan(value)) << value;
    }
}

TEST_F(Prober, CapsTheMessageOfAnException) {
    const protocol::Response response = ask("throws").responses[0];
    EXPECT_EQ(response.state, State::Threw);
    EXPECT_EQ(response.message, std::string(2000, 'x'));
}

TEST_F(Prober, ReadsNoiseAsNoAnswer) {
    for (const protocol::Response &response : ask("writes_noise").responses)
        EXPECT_EQ(response.state, State::Pending);
}

TEST_F(Prober, KeepsTheMemoryAsItIs) {
    const ProbeAnswer answer = ask("attacks_memory");
    EXPECT_TRUE(std::holds_alternative<BoxExited>(answer.outcome.end))
        << describe(answer.outcome.end);
    EXPECT_TRUE(answer.complete());
}

TEST_F(Prober, PassesTheTwoMemoriesAndNothingElse) {
    EXPECT_EQ(ask("lists_descriptors").outcome.log, "0 1 2 3 4 ");
}

TEST_F(Prober, AsksNothingWithoutAFault) {
    protocol::RequestGroup group;
    group.files = {{"answers_all", ""}};
    const ProbeAnswer answer = askProbe(sandbox(), m_probe, group);
    EXPECT_TRUE(std::holds_alternative<BoxExited>(answer.outcome.end))
        << describe(answer.outcome.end);
    EXPECT_TRUE(answer.responses.empty());
}

TEST_F(Prober, BlamesNobodyForAProbeThatIsNotThere) {
    m_probe = m_folder / "missing";
    const ProbeAnswer answer = ask("answers_all");
    EXPECT_TRUE(std::holds_alternative<BoxNotStarted>(answer.outcome.end));
    EXPECT_FALSE(answer.complete());
}

TEST_F(Prober, LeavesNoDescriptorOpen) {
    ask("answers_all");
    const long before = openDescriptors();
    for (int i = 0; i < 10; ++i)
        EXPECT_TRUE(ask("answers_all").complete());
    EXPECT_EQ(openDescriptors(), before);
}

} // namespace

} // namespace grader
