// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <unistd.h>

#include <fstream>
#include <iterator>

#include <exam/summary.h>

namespace exam {

namespace {

namespace fs = std::filesystem;

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

/// The same, but that a person must look at one of its items.
Graded withHuman(Graded result, std::size_t item) {
    result.items[item].verdict = "human";
    return result;
}

std::string textOf(const fs::path &file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
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

TEST(Judge, wants_what_is_visible_to_cost_by_a_visible_check) {
    EXPECT_FALSE(judge(patch(Patch::Cost::Visible), graded(9, {kLatent})).asExpected);
    EXPECT_FALSE(judge(patch(Patch::Cost::Visible), graded(9, {kRight, kLatent})).asExpected);
    EXPECT_TRUE(judge(patch(Patch::Cost::Visible), graded(5, {kLatent, kVisible})).asExpected);
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
    EXPECT_EQ(judge(mutant, graded(5, {kVisible})).diagnosis, "disk.no_root");
    EXPECT_EQ(judge(mutant, graded(5, {kLatent})).diagnosis, "");
}

TEST(Judge, looks_at_all_ids_of_a_check_but_only_where_the_item_has_none) {
    const Patch mutant = patch(Patch::Cost::Visible);
    GradedCheck both = kVisible;
    both.diagnoses = {"disk.wide_rim", "disk.no_root"};
    EXPECT_EQ(judge(mutant, graded(5, {both, kVisible})).diagnosisRank, 2U);
    Graded named = graded(5, {both});
    named.items[0].diagnoses = {"disk.no_root"};
    EXPECT_EQ(judge(mutant, named).diagnosisRank, 1U);
}

TEST(Judge, finds_the_diagnosis_of_a_blemish) {
    const GradedCheck remark = check("fail", "blemish", 0, "disk.no_root");
    EXPECT_EQ(judge(patch(Patch::Cost::Blemish), graded(10, {remark})).diagnosisRank, 1U);
    const GradedCheck other = check("fail", "blemish", 0, "disk.wide_rim");
    EXPECT_EQ(judge(patch(Patch::Cost::Blemish), graded(10, {other, remark})).diagnosisRank, 2U);
    EXPECT_EQ(judge(patch(Patch::Cost::Blemish), graded(10, {other})).diagnosisRank, 0U);
}

TEST(Judge, wants_a_variant_to_lose_nothing_and_to_get_no_diagnosis) {
    Patch variant = patch(Patch::Cost::Nothing);
    EXPECT_TRUE(judge(variant, graded(10, {kRight})).asExpected);
    EXPECT_FALSE(judge(variant, graded(10, {kLatent})).asExpected);
    EXPECT_TRUE(judge(variant, graded(10, {check("fail", "blemish", 0, "")})).asExpected);
    EXPECT_FALSE(judge(variant, graded(10, {check("fail", "blemish", 0, "disk.slow")})).asExpected);
    Graded missing = graded(0, {check("missing", "visible", 0, "")});
    missing.items[0].verdict = "missing";
    EXPECT_FALSE(judge(variant, missing).asExpected);
    variant.missing = {"warp.disk"};
    EXPECT_TRUE(judge(variant, missing).asExpected);
}

TEST(Judge, counts_other_items_at_which_a_person_must_look) {
    const Patch mutant = patch(Patch::Cost::Visible);
    const Graded alone = graded(5, {kVisible});
    EXPECT_EQ(judge(mutant, alone).humans, 0U);
    const Judgement downstream = judge(mutant, withHuman(alone, 1));
    EXPECT_EQ(downstream.humans, 1U);
    EXPECT_TRUE(downstream.asExpected) << "nothing is taken from it";
    EXPECT_NE(downstream.got.find("; warp.sphere 5/5: a person must look: "), std::string::npos)
        << downstream.got;
    EXPECT_EQ(judge(mutant, withHuman(alone, 0)).humans, 0U) << "it is no other item";
}

TEST(Judge, takes_nothing_at_which_a_person_must_look_for_judged) {
    const auto isRight = [](Patch::Cost cost, const Graded &result) {
        return judge(patch(cost), result).asExpected;
    };
    const Graded right = graded(10, {kRight});
    EXPECT_TRUE(isRight(Patch::Cost::Nothing, right));
    EXPECT_FALSE(isRight(Patch::Cost::Nothing, withHuman(right, 1)));
    EXPECT_FALSE(judge(patch(Patch::Cost::Nothing), withHuman(right, 1)).othersFull);
    const Graded wrong = graded(9, {kLatent});
    EXPECT_TRUE(isRight(Patch::Cost::Latent, wrong));
    EXPECT_FALSE(isRight(Patch::Cost::Latent, withHuman(wrong, 0)));
    EXPECT_FALSE(judge(patch(Patch::Cost::Latent), withHuman(wrong, 0)).lost);
    const Graded remarked = graded(10, {check("fail", "blemish", 0, "disk.slow")});
    EXPECT_TRUE(isRight(Patch::Cost::Blemish, remarked));
    EXPECT_FALSE(isRight(Patch::Cost::Blemish, withHuman(remarked, 0)));
    const std::string got = judge(patch(Patch::Cost::Blemish), withHuman(remarked, 0)).got;
    EXPECT_EQ(got, "warp.disk 10/10: a person must look: blemish measured.");
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

TEST(Summary, wants_of_each_rate_what_was_promised) {
    Judgement good;
    good.asExpected = good.lost = true;
    good.diagnosisRank = 1;
    Judgement unnamed = good;
    unnamed.diagnosisRank = 0;
    Judgement free = good;
    free.asExpected = free.lost = false;
    std::vector<PatchRecord> mutants(20, {patch(Patch::Cost::Visible), {good}, {good}});
    EXPECT_TRUE(reachesWanted(mutants));
    mutants[3].whole = {unnamed}; // 95 % within three, 95 % first
    EXPECT_TRUE(reachesWanted(mutants));
    mutants[4].whole = {unnamed};
    EXPECT_FALSE(reachesWanted(mutants));
    mutants[3].whole = mutants[4].whole = {good};
    mutants[5].item = {free};
    EXPECT_FALSE(reachesWanted(mutants)); // 95 %, wanted 98
    EXPECT_FALSE(reachesWanted({{patch(Patch::Cost::Nothing), {good, free}, {}}}));
    EXPECT_NE(summarise(mutants).find("; at least 85 % is wanted\n"), std::string::npos);
}

TEST(Summary, wants_every_grading_of_a_mistake_to_cost_and_something_to_be_measured) {
    Judgement good;
    good.asExpected = good.lost = true;
    good.diagnosisRank = 1;
    Judgement vague = good; // it costs, but not what it should
    vague.asExpected = false;
    Judgement free = vague;
    free.lost = false;
    std::vector<PatchRecord> mutants(100, {patch(Patch::Cost::Visible), {good}, {good}});
    mutants[5].item = {vague}; // 99 %, wanted 98
    EXPECT_TRUE(reachesWanted(mutants));
    EXPECT_NE(summarise(mutants).find("as expected with every seed: 99 of 100"), std::string::npos);
    mutants[5].item = {free};
    EXPECT_FALSE(reachesWanted(mutants));
    mutants[5].patch.cost = Patch::Cost::Blemish; // which costs nothing
    EXPECT_TRUE(reachesWanted(mutants));
    EXPECT_NE(summarise(mutants).find("gradings that lose points: 99 of 99"), std::string::npos);
    EXPECT_FALSE(reachesWanted({}));
    EXPECT_FALSE(reachesWanted({{patch(Patch::Cost::Visible), {}, {}}}));
}

TEST(Summary, tells_after_how_many_mutants_a_person_must_look) {
    Judgement good;
    good.asExpected = good.lost = true;
    Judgement looked = good;
    looked.humans = 2;
    const Patch mutant = patch(Patch::Cost::Visible);
    EXPECT_NE(summarise({{mutant, {looked}, {}}, {mutant, {good}, {}}, {mutant, {}, {good}}})
                  .find("must look at another item: 1 of 2\n"),
              std::string::npos);
    EXPECT_EQ(summarise({{patch(Patch::Cost::Nothing), {looked}, {}}}).find("must look"),
              std::string::npos);
}

TEST(Summary, says_where_a_mistake_makes_no_difference) {
    Patch mutant = patch(Patch::Cost::Visible);
    mutant.what = "The density is that of the first light.";
    EXPECT_NE(markdown({{mutant, {}, {}}}, "1234567").find("first light. | warp.disk"),
              std::string::npos);
    mutant.equivalent = "one light";
    EXPECT_NE(markdown({{mutant, {}, {}}}, "1234567")
                  .find("first light. *No difference: one light.* | warp.disk"),
              std::string::npos);
}

TEST(Summary, counts_apart_what_a_rate_leaves_out) {
    Judgement good;
    good.asExpected = good.lost = true;
    good.diagnosisRank = 1;
    good.diagnosis = "disk.no_root";
    Judgement vague = good;
    vague.diagnosis = "warp.density_of_points";
    Patch unnamed = patch(Patch::Cost::Visible);
    unnamed.diagnoses.clear();
    const std::vector<PatchRecord> records = {{patch(Patch::Cost::Visible), {good}, {}},
                                              {patch(Patch::Cost::Visible), {vague}, {}},
                                              {patch(Patch::Cost::Blemish), {good}, {}},
                                              {unnamed, {good}, {}}};
    const std::string apart =
        "apart: 1 remarks that by the rubric cost nothing, 1 mutants that no diagnosis fits\n";
    for (const std::string &text : {summarise(records), markdown(records, "1234567")}) {
        EXPECT_NE(text.find("lose points: 3 of 3"), std::string::npos) << text;
        EXPECT_NE(text.find("of mutants that have one: 3 of 3"), std::string::npos) << text;
        EXPECT_NE(text.find("and no catch-all, of the same: 2 of 3"), std::string::npos) << text;
        EXPECT_NE(text.find(apart), std::string::npos) << text;
    }
    EXPECT_NE(markdown(records, "1234567").find("| none fits |\n"), std::string::npos);
    EXPECT_EQ(summarise({{patch(Patch::Cost::Nothing), {good}, {}}}).find("apart"),
              std::string::npos);
}

TEST(Record, replaces_its_section_alone) {
    const fs::path file = fs::temp_directory_path() / ("record." + std::to_string(getpid()));
    const std::string rest = "<!-- b: begin -->\nNot run yet.\n<!-- b: end -->\n";
    std::ofstream(file) << "<!-- a: begin -->\nNot run yet.\n<!-- a: end -->\n" << rest;
    replaceSection(file, "a", "Measured.\n");
    EXPECT_EQ(textOf(file), "<!-- a: begin -->\nMeasured.\n<!-- a: end -->\n" + rest);
    EXPECT_THROW(replaceSection(file, "c", ""), ExamError);
    fs::remove(file);
}

TEST(Record, says_in_every_section_what_was_measured_or_that_nothing_was) {
    const std::string text = textOf(fs::path(NORI_SOURCE_DIR) / "tests" / "exam.md");
    const std::string begin = ": begin -->\n";
    std::size_t sections = 0;
    for (std::size_t at = 0; (at = text.find(begin, at)) != std::string::npos; ++sections) {
        at += begin.size();
        EXPECT_NE(text.compare(at, 4, "<!--"), 0) << text.substr(at, 40);
    }
    EXPECT_GE(sections, 8U);
}

} // namespace exam
