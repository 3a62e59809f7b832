// SPDX-License-Identifier: MIT
#include <support/probe_child.h>

#include <gtest/gtest.h>

#include <csignal>

namespace {

using protocol::Op;
using protocol::State;

constexpr char kProbe[] = NORI_PROBE_REFERENCE;
constexpr char kFaulty[] = NORI_PROBE_FAULTY;

protocol::Request warpRequest() {
    protocol::Request request;
    request.op = Op::WarpSample;
    request.text = "square";
    request.values = {0.25F, 0.75F};
    return request;
}

/// A warp, a question to a faulty emitter, the warp again.
protocol::RequestGroup around(const std::string &mistake) {
    protocol::RequestGroup group;
    group.files = {test::sceneFile(R"(<emitter type="faulty"><string name="mistake" value=")" +
                                   mistake + "\"/></emitter>")};
    group.requests = {warpRequest(),
                      test::sceneRequest(Op::EmitterSample, {0, 0, 0, 0.5F, 0.5F, 0.5F}),
                      warpRequest()};
    return group;
}

TEST(Probe, GoesOnAfterAnException) {
    const test::ProbeRun run = test::runProbe(kFaulty, around("eval_throws_int"));
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_EQ(run.responses[0].state, State::Done);
    EXPECT_EQ(run.responses[1].state, State::Threw);
    EXPECT_TRUE(run.responses[1].values.empty());
    EXPECT_EQ(run.responses[2].state, State::Done);
}

TEST(Probe, LeavesEarlierAnswersWhenItCrashes) {
    const test::ProbeRun run = test::runProbe(kFaulty, around("eval_aborts"));
    EXPECT_EQ(run.signalNumber, SIGABRT);
    EXPECT_EQ(run.responses[0].state, State::Done);
    EXPECT_EQ(run.responses[0].values, warpRequest().values);
    EXPECT_EQ(run.responses[1].state, State::Pending);
    EXPECT_EQ(run.responses[2].state, State::Pending);
}

TEST(Probe, LeavesLaterAnswersPendingWhenTheCodeExits) {
    const test::ProbeRun run = test::runProbe(kFaulty, around("sample_exits"));
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_EQ(run.responses[0].state, State::Done);
    EXPECT_EQ(run.responses[1].state, State::Pending);
    EXPECT_EQ(run.responses[2].state, State::Pending);
}

TEST(Probe, TellsTheTimeOfEveryAnswer) {
    const test::ProbeRun run = test::runProbe(kProbe, around("none"));
    // The reference knows no such emitter: an exception takes time too.
    EXPECT_EQ(run.responses[1].state, State::Threw);
    for (const protocol::Response &response : run.responses) {
        EXPECT_GT(response.cpuSeconds, 0.0);
        EXPECT_LT(response.cpuSeconds, 20.0);
    }
}

TEST(Probe, EndsWellWithoutQuestions) {
    EXPECT_EQ(test::runProbe(kProbe, {}).exitCode, 0);
}

TEST(Probe, AnswersNothingWhenItCannotReadTheQuestions) {
    const protocol::RequestGroup group{{}, {warpRequest()}};
    for (const std::string &questions :
         {std::string(), std::string("garbage"), protocol::encode(group) + "x"}) {
        const test::ProbeRun run = test::runProbe(kProbe, group, questions);
        EXPECT_EQ(run.exitCode, 1);
        EXPECT_EQ(run.responses[0].state, State::Pending);
    }
}

TEST(Probe, AnswersNothingWhenTheAnswersDoNotFit) {
    protocol::RequestGroup larger{{}, {warpRequest(), warpRequest()}};
    const protocol::RequestGroup group{{}, {warpRequest()}};
    const test::ProbeRun run = test::runProbe(kProbe, group, protocol::encode(larger));
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_EQ(run.responses[0].state, State::Pending);
}

} // namespace
