// SPDX-License-Identifier: MIT
#include <grader/checks/answer.h>

#include <gtest/gtest.h>

#include "fake_context.h"

namespace grader {
namespace {

ProbeAnswer ended(BoxEnd end, protocol::State state = protocol::State::Pending,
                  const std::string &message = "") {
    ProbeAnswer answer;
    answer.outcome.end = std::move(end);
    answer.responses = {{state, message, 0, {}}};
    return answer;
}

TEST(Unanswered, IsNothingWhenEveryRequestIsDone) {
    EXPECT_FALSE(unanswered(answerWith({1})).has_value());
}

TEST(Unanswered, NamesWhoseFaultItIs) {
    using protocol::State;
    const std::pair<ProbeAnswer, Verdict> cases[] = {
        {ended(BoxNotStarted{"no"}), Verdict::Infra},
        {ended(BoxStarved{70}), Verdict::Infra},
        {ended(BoxTimedOut{true}), Verdict::Timeout},
        {ended(BoxSignalled{11}), Verdict::Crash},
        {ended(BoxOutOfMemory{}), Verdict::Crash},
        // exit(0) without an answer is no success
        {ended(BoxExited{0}), Verdict::Crash},
        {ended(BoxExited{0}, State::Threw, "Warp::squareToTent() is not yet implemented!"),
         Verdict::Missing},
        {ended(BoxExited{0}, State::Threw, "Función no implementada"), Verdict::Missing},
        {ended(BoxExited{0}, State::Threw, "vector::at"), Verdict::Fail},
    };
    for (const auto &[answer, verdict] : cases) {
        const auto result = unanswered(answer);
        ASSERT_TRUE(result.has_value());
        EXPECT_EQ(result->verdict, verdict) << result->message;
    }
}

TEST(Explain, NamesWhatIsKeptFirstOnlyWhereConfirmedErrorsDiffer) {
    using statistics::Decision;
    const std::vector<Guess> guesses = {{"warp.rounded", 0.9}};
    const auto first = [&](Decision decision, bool sameDeviation) {
        return explain({decision, {}, sameDeviation}, guesses).front().id;
    };
    EXPECT_EQ(first(Decision::Fail, false), "samples.kept");
    EXPECT_EQ(first(Decision::Fail, true), "warp.rounded");
    EXPECT_EQ(first(Decision::Inconclusive, false), "warp.rounded");
    EXPECT_EQ(explain({Decision::Fail, {}, false}, guesses).size(), 2u);
}

} // namespace
} // namespace grader
