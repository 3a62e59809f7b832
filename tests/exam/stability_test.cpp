// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include <exam/stability.h>

namespace exam {

namespace {

Graded graded(double points, const char *verdict = "fail", const char *message = "off by 1 %") {
    GradedCheck check;
    check.id = "warp.disk.samples";
    check.verdict = verdict;
    check.message = message;
    Graded result;
    result.items = {{"warp.disk", points, 10, verdict, "why", {}, {check}},
                    {"area_light", 30, 30, "pass", "", {}, {}}};
    return result;
}

StabilityRecord record(Standing standing, std::vector<Graded> seeds) {
    return {"disk", "", standing, std::move(seeds), {}, {}};
}

} // namespace

TEST(Stability, asks_every_point_in_every_grading_of_what_is_right) {
    EXPECT_TRUE(record(Standing::Accepted, {graded(10), graded(10)}).asExpected());
    EXPECT_FALSE(record(Standing::Accepted, {graded(10), graded(9.99)}).asExpected());
    EXPECT_FALSE(record(Standing::Accepted, {graded(9), graded(9)}).asExpected());
}

TEST(Stability, asks_the_same_points_of_what_is_wrong) {
    EXPECT_TRUE(record(Standing::Wrong, {graded(5), graded(5)}).asExpected());
    EXPECT_FALSE(record(Standing::Wrong, {graded(5), graded(5.01)}).asExpected());
    EXPECT_FALSE(record(Standing::Wrong, {graded(10), graded(10)}).asExpected());
}

TEST(Stability, allows_what_is_borderline_half_a_point_of_standard_deviation) {
    const StabilityRecord near = record(Standing::Borderline, {graded(7), graded(7.6)});
    EXPECT_NEAR(near.standardDeviation(), 0.6 / std::sqrt(2.0), 1e-12);
    EXPECT_DOUBLE_EQ(near.smallest(), 37);
    EXPECT_DOUBLE_EQ(near.largest(), 37.6);
    EXPECT_TRUE(near.asExpected());
    EXPECT_FALSE(record(Standing::Borderline, {graded(7), graded(7.8)}).asExpected());
}

TEST(Stability, counts_verdicts_that_change_with_the_seed) {
    const auto changing =
        record(Standing::Borderline, {graded(9), graded(10, "pass"), graded(9)}).changingChecks();
    ASSERT_EQ(changing.size(), 1U);
    EXPECT_EQ(changing.at("warp.disk.samples"), (VerdictCounts{{"fail", 2}, {"pass", 1}}));
    EXPECT_TRUE(record(Standing::Wrong, {graded(9), graded(9)}).changingChecks().empty());
}

TEST(Stability, tells_of_another_verdict_in_another_setting) {
    StabilityRecord wrong = record(Standing::Wrong, {graded(5), graded(5)});
    wrong.plain = {graded(5, "fail", "off by 1.01 %")}; // another build rounds otherwise
    EXPECT_TRUE(wrong.asExpected());
    wrong.plain = {graded(5, "timeout")};
    EXPECT_FALSE(wrong.asExpected());
    EXPECT_NE(describeStability({wrong}).find("warp.disk.samples with seed 0: fail, then timeout"),
              std::string::npos)
        << describeStability({wrong});
}

TEST(Stability, wants_every_number_the_same_with_two_processes) {
    StabilityRecord wrong = record(Standing::Wrong, {graded(5)});
    wrong.pairs = {graded(5)};
    EXPECT_TRUE(wrong.asExpected());
    wrong.pairs = {graded(5, "fail", "off by 1.01 %")};
    EXPECT_FALSE(wrong.asExpected());
}

TEST(Stability, counts_pass_and_inconclusive_without_complaint) {
    StabilityRecord right = record(Standing::Accepted, {graded(10, "pass")});
    right.plain = {graded(10, "inconclusive")};
    EXPECT_TRUE(right.asExpected());
    EXPECT_NE(stabilityMarkdown({right}, "abc").find("1 times pass and inconclusive"),
              std::string::npos);
    right.plain = {graded(10, "fail")};
    EXPECT_FALSE(right.asExpected());
}

TEST(Stability, misses_no_check_that_was_not_run) {
    Graded without = graded(5);
    without.items[0].checks.clear();
    const auto changes = verdictChanges(graded(5), without, false);
    ASSERT_EQ(changes.size(), 1U);
    EXPECT_EQ(changes[0].after, "not run");
}

} // namespace exam
