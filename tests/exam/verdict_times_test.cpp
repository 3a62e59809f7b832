// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <exam/verdict_times.h>

namespace exam {

namespace {

ItemTime item(const char *id, bool isGross, double wall) {
    return {"wrong/it", id, isGross, wall, wall / 2, 3 * wall, 2 * wall, 0.1, "area.value", wall};
}

VerdictTime timed(bool isRight, double total, std::vector<ItemTime> items) {
    return {"it",
            isRight,
            {{"ingest", 0.1},
             {"compile", 5},
             {"link", 1},
             {"sample", 3},
             {"judge", 2},
             {"figures", 0.5},
             {"total", total}},
            std::move(items)};
}

} // namespace

TEST(SpreadOf, gives_the_middle_and_what_few_exceed) {
    EXPECT_DOUBLE_EQ(spreadOf({3, 1, 2}).median, 2);
    EXPECT_DOUBLE_EQ(spreadOf({4, 1, 2, 3}).median, 2.5);
    EXPECT_DOUBLE_EQ(spreadOf({7}).p95, 7);
    std::vector<double> values;
    for (int i = 1; i <= 100; ++i)
        values.push_back(i);
    EXPECT_DOUBLE_EQ(spreadOf(values).p95, 95);
}

TEST(VerdictTimes, call_gross_what_has_one_grossly_wrong_item) {
    EXPECT_STREQ(timed(true, 10, {}).kind(), "correct");
    EXPECT_STREQ(timed(false, 10, {item("warp.disk", false, 1)}).kind(), "subtly wrong");
    EXPECT_STREQ(
        timed(false, 10, {item("warp.disk", false, 1), item("area_light", true, 1)}).kind(),
        "grossly wrong");
}

TEST(VerdictTimes, name_grossly_wrong_items_that_are_late_and_no_others) {
    const std::vector<VerdictTime> times = {
        timed(true, 10, {}), timed(false, 20, {item("area_light", true, 2.5)}),
        timed(false, 30, {item("warp.disk", true, 1), item("warp.sphere", false, 9)})};
    const std::vector<ItemTime> late = lateItems(times);
    ASSERT_EQ(late.size(), 1U);
    EXPECT_EQ(late[0].item, "area_light");
    const std::string text = timesMarkdown(times, "abc");
    EXPECT_NE(text.find("| correct | 1 | 0.10 (0.10) |"), std::string::npos) << text;
    EXPECT_NE(text.find("2 grossly wrong items"), std::string::npos) << text;
    EXPECT_NE(
        text.find(
            "- area_light in wrong/it: 2.50 s of sampling (1.25 s of CPU); all checks: 5.00 s"),
        std::string::npos)
        << text;
    EXPECT_EQ(describeTimes(times).find("warp.sphere"), std::string::npos);
}

} // namespace exam
