// SPDX-License-Identifier: MIT
#include <grader/engine/reference_answers.h>

#include <gtest/gtest.h>

namespace grader {

namespace {

protocol::RequestGroup question(std::uint64_t seed) {
    protocol::Request request;
    request.op = protocol::Op::Image;
    request.text = "scene.xml";
    request.repeats = 2;
    request.seed = seed;
    request.values = {0, 1};
    return {{{"scene.xml", "<scene/>"}}, {request}};
}

ProbeAnswer answer(std::size_t floats, protocol::State state = protocol::State::Done) {
    protocol::Response response;
    response.state = state;
    response.values.assign(floats, 0.5F);
    ProbeAnswer result;
    result.responses = {response};
    return result;
}

} // namespace

TEST(ReferenceAnswers, AreForTheVerySameQuestion) {
    ReferenceAnswers known;
    EXPECT_EQ(known.find(question(1)), nullptr);
    known.keep(question(1), answer(12));
    ASSERT_NE(known.find(question(1)), nullptr);
    EXPECT_EQ(known.find(question(1))->responses[0].values.size(), 12U);
    EXPECT_EQ(known.find(question(2)), nullptr);
    protocol::RequestGroup other = question(1);
    other.files[0].bytes = "<scene />";
    EXPECT_EQ(known.find(other), nullptr);
    other = question(1);
    other.requests[0].repeats = 4;
    EXPECT_EQ(known.find(other), nullptr);
    other = question(1);
    other.requests[0].values[1] = 2;
    EXPECT_EQ(known.find(other), nullptr);
    other = question(1);
    other.requests.push_back(other.requests[0]);
    EXPECT_EQ(known.find(other), nullptr);
}

TEST(ReferenceAnswers, KeepNoFailure) {
    ReferenceAnswers known;
    known.keep(question(1), answer(0, protocol::State::Threw));
    EXPECT_EQ(known.find(question(1)), nullptr);
}

TEST(ReferenceAnswers, Keep64MiBAndNoMore) {
    constexpr std::size_t kMiB = (std::size_t{1} << 20) / sizeof(float);
    ReferenceAnswers known;
    known.keep(question(1), answer(40 * kMiB));
    known.keep(question(2), answer(40 * kMiB));
    known.keep(question(3), answer(24 * kMiB));
    EXPECT_NE(known.find(question(1)), nullptr);
    EXPECT_EQ(known.find(question(2)), nullptr);
    EXPECT_NE(known.find(question(3)), nullptr);
}

} // namespace grader
