// SPDX-License-Identifier: MIT
#include <grader/checks/thread_check.h>

#include <gtest/gtest.h>

#include <csignal>
#include <limits>

#include "fake_context.h"

namespace grader {
namespace {

ProbeAnswer answerWithBoth(std::vector<float> one, std::vector<float> several) {
    ProbeAnswer answer = answerWith(std::move(one));
    answer.responses.push_back({protocol::State::Done, "", 0, std::move(several)});
    return answer;
}

CheckResult judge(FakeContext &context) {
    protocol::RequestGroup group;
    group.requests.resize(2);
    group.requests[1].index = kThreads - 1;
    return compareThreads(context, group, "samples", "ems.shared_state");
}

} // namespace

TEST(CompareThreads, PassesWhatIsTheSameBitForBit) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    FakeContext context([&](const auto &) { return answerWithBoth({1, nan}, {1, nan}); });
    EXPECT_EQ(judge(context).verdict, Verdict::Pass);
    EXPECT_EQ(context.asked, 1);
}

TEST(CompareThreads, FailsWhatDiffersOnSeveralAlone) {
    FakeContext context([](const protocol::RequestGroup &group) {
        return answerWithBoth({1, 2}, {1, group.requests[1].index > 0 ? 3.0F : 2.0F});
    });
    const CheckResult result = judge(context);
    EXPECT_EQ(result.verdict, Verdict::Fail);
    EXPECT_EQ(result.message, "On 4 threads 1 of 2 samples are not as on one.");
    ASSERT_EQ(result.diagnoses.size(), 1U);
    EXPECT_EQ(result.diagnoses[0].id, "ems.shared_state");
}

TEST(CompareThreads, BlamesThreadsForNothingThatOneDoesToo) {
    FakeContext context([](const auto &) { return answerWithBoth({1, 2}, {1, 3}); });
    EXPECT_EQ(judge(context).verdict, Verdict::Pass);
}

TEST(CompareThreads, HandsOnThatThereIsNoAnswer) {
    FakeContext context([](const auto &) {
        ProbeAnswer answer = answerWithBoth({1}, {});
        answer.responses[1].state = protocol::State::Pending;
        answer.outcome.end = BoxSignalled{SIGSEGV};
        return answer;
    });
    EXPECT_EQ(judge(context).verdict, Verdict::Crash);
}

} // namespace grader
