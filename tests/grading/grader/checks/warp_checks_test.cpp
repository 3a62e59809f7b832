// SPDX-License-Identifier: MIT
#include <grader/checks/check.h>

#include <gtest/gtest.h>

#include <cmath>

#include "fake_context.h"

namespace grader {
namespace {

/// Answers with a map of the unit square to the triangle.
FakeContext contextOf(float (*root)(float u, float v)) {
    return FakeContext([root](const protocol::RequestGroup &group) {
        ProbeAnswer answer = answerWith({});
        answer.responses.clear();
        for (const protocol::Request &request : group.requests) {
            std::vector<float> points;
            for (std::size_t i = 0; i + 1 < request.values.size(); i += 2) {
                const float r = root(request.values[i], request.values[i + 1]);
                points.push_back(1 - r);
                points.push_back(request.values[i + 1] * r);
            }
            answer.responses.push_back({protocol::State::Done, "", 0, std::move(points)});
        }
        return answer;
    });
}

} // namespace

TEST(WarpEdges, PassForARightWarp) {
    FakeContext context = contextOf([](float u, float) { return std::sqrt(u); });
    EXPECT_EQ(findCheck("warp.triangle.edges")->run(context).verdict, Verdict::Pass);
}

TEST(WarpEdges, FindADivisionByZeroThatNoImageShows) {
    FakeContext context =
        contextOf([](float u, float v) { return std::sqrt(u) * ((u + v) / (u + v)); });
    const CheckResult result = findCheck("warp.triangle.edges")->run(context);
    EXPECT_EQ(result.verdict, Verdict::Fail);
    EXPECT_NE(result.message.find("first for the sample (0, 0)"), std::string::npos)
        << result.message;
}

TEST(WarpSamples, KeepAMapOfPointsThatAreWrong) {
    FakeContext context = contextOf([](float u, float) { return u * u; });
    const CheckResult result = findCheck("warp.triangle.samples")->run(context);
    EXPECT_EQ(result.verdict, Verdict::Fail);
    EXPECT_EQ(result.message.find("e+"), std::string::npos) << result.message;
    ASSERT_TRUE(result.map);
    EXPECT_EQ(result.map->warp, "triangle");
    ASSERT_EQ(result.map->counts.size(), 1024U);
    // P(r < 1/16) = 1/4 of r = u^2, 1/256 of a right warp: x = 1 - r in the last two columns
    std::size_t inside = 0;
    std::size_t right = 0;
    for (std::size_t cell = 0; cell < 1024; ++cell) {
        inside += result.map->counts[cell];
        right += cell % 32 >= 30 ? result.map->counts[cell] : 0;
    }
    EXPECT_EQ(inside, result.map->points);
    EXPECT_NEAR(static_cast<double>(right) / static_cast<double>(inside), 0.25, 0.01);
}

TEST(WarpSamples, KeepNoMapOfPointsThatAreRight) {
    FakeContext context = contextOf([](float u, float) { return std::sqrt(u); });
    const CheckResult result = findCheck("warp.triangle.samples")->run(context);
    EXPECT_EQ(result.verdict, Verdict::Pass) << result.message;
    EXPECT_FALSE(result.map);
}

} // namespace grader
