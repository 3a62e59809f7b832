// SPDX-License-Identifier: MIT
#include <grader/calibration/judgement.h>

#include <gtest/gtest.h>

namespace grader {

namespace {

/// Two items of 10 points with one check each, `disk.a` and `area.b`.
Rubric rubricOf() {
    Rubric rubric;
    rubric.cap = 20;
    for (const char *id : {"disk", "area"}) {
        RubricItem item;
        item.id = item.title = id;
        item.points = 10;
        RubricCheck check;
        check.id = std::string(id) + ".a";
        check.tolerance = 0.01;
        check.gross = 0.5;
        item.checks = {check};
        rubric.items.push_back(item);
    }
    return rubric;
}

std::vector<CheckResult> outcomesOf(Verdict disk, double effect, Verdict area = Verdict::Pass) {
    std::vector<CheckResult> outcomes(2);
    outcomes[0].id = "disk.a";
    outcomes[0].verdict = disk;
    outcomes[0].effect = effect;
    outcomes[1].id = "area.a";
    outcomes[1].verdict = area;
    outcomes[1].effect = 1;
    return outcomes;
}

CorpusCase wrongDisk() {
    CorpusCase which;
    which.name = "submissions/wrong/disk";
    which.lost = {"disk"};
    return which;
}

} // namespace

TEST(JudgeCase, is_content_when_a_mistake_costs_its_item_alone) {
    EXPECT_TRUE(judgeCase(rubricOf(), wrongDisk(), outcomesOf(Verdict::Fail, 0.2)).empty());
    EXPECT_TRUE(judgeCase(rubricOf(), CorpusCase(), outcomesOf(Verdict::Pass, 0)).empty());
}

TEST(JudgeCase, says_that_a_check_is_missing) {
    const auto findings = judgeCase(rubricOf(), wrongDisk(), outcomesOf(Verdict::Pass, 0));
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_NE(findings[0].find("no check of disk finds it"), std::string::npos) << findings[0];
}

TEST(JudgeCase, says_which_weight_or_tolerance_makes_a_mistake_free) {
    const auto findingWith = [](const RubricCheck &check, double effect) {
        Rubric rubric = rubricOf();
        rubric.items[0].checks = {check};
        const auto findings = judgeCase(rubric, wrongDisk(), outcomesOf(Verdict::Fail, effect));
        return findings.empty() ? std::string() : findings[0];
    };
    RubricCheck check = rubricOf().items[0].checks[0];
    std::vector<CheckResult> uncertain = outcomesOf(Verdict::Fail, 0.05);
    uncertain[0].floor = 0.1;
    const auto findings = judgeCase(rubricOf(), wrongDisk(), uncertain);
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_NE(findings[0].find("only some seeds find"), std::string::npos) << findings[0];
    EXPECT_NE(findingWith(check, 0.005).find("within the tolerance of 0.01"), std::string::npos);
    check.severity = Severity::Blemish;
    EXPECT_NE(findingWith(check, 1).find("it is a blemish"), std::string::npos);
    check.severity = Severity::Visible;
    check.weight = 0;
    EXPECT_NE(findingWith(check, 1).find("its weight is 0"), std::string::npos);
}

TEST(JudgeCase, lets_nobody_look_at_right_code) {
    const std::vector<CheckResult> outcomes = outcomesOf(Verdict::Pass, 0, Verdict::Human);
    const auto findings = judgeCase(rubricOf(), CorpusCase(), outcomes);
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_NE(findings[0].find("someone has to look"), std::string::npos) << findings[0];
    CorpusCase optional; // the part is not in it
    optional.free = {"area"};
    EXPECT_TRUE(judgeCase(rubricOf(), optional, outcomes).empty());
}

TEST(JudgeCase, tells_of_points_that_right_code_loses) {
    EXPECT_EQ(judgeCase(rubricOf(), CorpusCase(), outcomesOf(Verdict::Fail, 0.2)).size(), 1U);
    EXPECT_EQ(
        judgeCase(rubricOf(), wrongDisk(), outcomesOf(Verdict::Fail, 0.2, Verdict::Fail)).size(),
        1U);
    CorpusCase variant;
    variant.free = {"disk"};
    EXPECT_TRUE(judgeCase(rubricOf(), variant, outcomesOf(Verdict::Missing, 0)).empty());
}

TEST(JudgeCase, wants_nothing_for_the_starter_and_the_cap_for_what_is_right) {
    CorpusCase starter;
    starter.isStarter = true;
    EXPECT_EQ(judgeCase(rubricOf(), starter, outcomesOf(Verdict::Missing, 0)).size(), 1U);
    Rubric rubric = rubricOf();
    rubric.cap = 30;
    EXPECT_EQ(judgeCase(rubric, CorpusCase(), outcomesOf(Verdict::Pass, 0)).size(), 1U);
}

TEST(JudgeCase, never_takes_our_own_failure_for_a_result) {
    EXPECT_EQ(judgeCase(rubricOf(), wrongDisk(), outcomesOf(Verdict::Infra, 0)).size(), 1U);
}

} // namespace grader
