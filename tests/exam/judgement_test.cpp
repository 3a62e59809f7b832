// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <exam/summary.h>

namespace exam {

namespace {

GradedCheck check(const char *verdict, const char *severity, double score, const char *diagnosis) {
    GradedCheck result;
    result.verdict = verdict;
    result.severity = severity;
    result.score = score;
    result.message = std::string(severity) + " measured.";
    if (*diagnosis != '\0')
        result.diagnoses = {diagnosis};
    return result;
}

/// A disk with these checks, and another item.
Graded graded(double disk, std::vector<GradedCheck> checks, double other = 5) {
    Graded result;
    result.items.resize(2);
    result.items[0] = {"warp.disk",      disk, 10, "fail", checks.front().message, {},
                       std::move(checks)};
    result.items[1] = {"warp.sphere", other, 5, "pass", "", {}, {}};
    return result;
}

Patch patch(Patch::Cost cost) {
    Patch result;
    result.cost = cost;
    result.item = cost == Patch::Cost::Nothing ? "" : "warp.disk";
    result.diagnoses = {"disk.no_root"};
    return result;
}

const GradedCheck kVisible = check("fail", "visible", 0, "disk.no_root");
const GradedCheck kLatent = check("fail", "latent", 0.5, "disk.wide_rim");
const GradedCheck kRight = check("pass", "visible", 1, "");

} // namespace

TEST(Judge, wants_a_mistake_to_cost_its_item_alone) {
    const Patch mutant = patch(Patch::Cost::Visible);
    EXPECT_TRUE(judge(mutant, graded(5, {kVisible})).asExpected);
    EXPECT_FALSE(judge(mutant, graded(10, {kRight})).lost);
    const Judgement both = judge(mutant, graded(5, {kVisible}, 3));
    EXPECT_TRUE(both.lost);
    EXPECT_FALSE(both.othersFull);
    EXPECT_FALSE(both.asExpected);
}

TEST(Judge, wants_what_is_latent_to_cost_by_latent_checks_alone) {
    EXPECT_TRUE(judge(patch(Patch::Cost::Latent), graded(9, {kLatent})).asExpected);
    EXPECT_FALSE(judge(patch(Patch::Cost::Latent), graded(5, {kVisible, kLatent})).asExpected);
}

TEST(Judge, wants_a_blemish_to_be_remarked_on_and_cost_nothing) {
    const Patch mutant = patch(Patch::Cost::Blemish);
    const GradedCheck remark = check("fail", "blemish", 0, "disk.slow");
    EXPECT_TRUE(judge(mutant, graded(10, {remark})).asExpected);
    EXPECT_FALSE(judge(mutant, graded(10, {kRight})).asExpected);
    EXPECT_FALSE(judge(mutant, graded(9, {remark})).asExpected);
}

TEST(Judge, finds_the_rank_of_the_right_diagnosis) {
    const Patch mutant = patch(Patch::Cost::Visible);
    EXPECT_EQ(judge(mutant, graded(5, {kVisible, kLatent})).diagnosisRank, 1U);
    EXPECT_EQ(judge(mutant, graded(5, {kLatent, kVisible})).diagnosisRank, 2U);
    EXPECT_EQ(judge(mutant, graded(5, {kLatent})).diagnosisRank, 0U);
}

TEST(Judge, wants_a_variant_to_lose_nothing_and_to_get_no_diagnosis) {
    Patch variant = patch(Patch::Cost::Nothing);
    EXPECT_TRUE(judge(variant, graded(10, {kRight})).asExpected);
    EXPECT_FALSE(judge(variant, graded(10, {kLatent})).asExpected);
    Graded missing = graded(0, {check("missing", "visible", 0, "")});
    missing.items[0].verdict = "missing";
    EXPECT_FALSE(judge(variant, missing).asExpected);
    variant.missing = {"warp.disk"};
    EXPECT_TRUE(judge(variant, missing).asExpected);
}

TEST(Summary, gives_rates_with_their_bounds) {
    Judgement good;
    good.asExpected = good.lost = true;
    good.diagnosisRank = 2;
    const std::string text = summarise({{patch(Patch::Cost::Visible), {good}, {good, {}}}});
    EXPECT_NE(text.find("lose points: 1 of 1 = 100.0 % (95 %: 2.5 to 100.0 %)"), std::string::npos)
        << text;
    EXPECT_NE(text.find("first diagnosis right, of mutants that have one: 0 of 1"),
              std::string::npos);
    EXPECT_NE(text.find("within three: 1 of 1"), std::string::npos);
    EXPECT_NE(text.find("further seeds: gradings as expected: 1 of 2"), std::string::npos);
}

} // namespace exam
