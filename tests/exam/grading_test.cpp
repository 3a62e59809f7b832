// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>

#include <exam/grading.h>

namespace exam {

namespace {

Graded graded(double total, double disk, const char *verdict = "pass") {
    Graded result;
    result.total = total;
    result.items = {{"warp.disk", disk, 10, verdict, "why", {}, {}},
                    {"area_light", 30, 30, "pass", "", {}, {}}};
    return result;
}

/// What the reader makes of the text of an expected.toml.
Expectation read(const std::string &text) {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("expected-" + std::to_string(getpid()) + ".toml");
    std::ofstream(file) << text;

    const std::unique_ptr<const std::filesystem::path, void (*)(const std::filesystem::path *)>
        remover(&file, [](const std::filesystem::path *path) { std::filesystem::remove(*path); });
    return readExpectation(file);
}

} // namespace

TEST(Compare, finds_nothing_where_all_is_as_expected) {
    const Expectation expectation =
        read("total = 100\nlost = [\"warp.disk\"]\nfull = \"others\"\n");
    EXPECT_TRUE(compare(expectation, graded(100, 5)).empty());
}

TEST(Compare, tells_of_an_item_that_kept_its_points) {
    const auto misses = compare(read("lost = [\"warp.disk\"]\n"), graded(100, 10));
    ASSERT_EQ(misses.size(), 1U);
    EXPECT_NE(misses[0].find("warp.disk got 10 of 10"), std::string::npos) << misses[0];
}

TEST(Compare, tells_of_an_item_that_lost_points_though_it_is_not_named) {
    EXPECT_EQ(compare(read("full = \"all\"\n"), graded(100, 9.5)).size(), 1U);
}

TEST(Compare, takes_a_few_points_for_more_than_zero) {
    EXPECT_EQ(compare(read("zero = [\"warp.disk\"]\n"), graded(100, 0.5)).size(), 1U);
    EXPECT_TRUE(compare(read("zero = [\"warp.disk\"]\n"), graded(100, 0)).empty());
}

TEST(Compare, holds_the_total_to_its_range) {
    const Expectation expectation = read("total = { min = 10, max = 70 }\n");
    EXPECT_TRUE(compare(expectation, graded(70, 0)).empty());
    EXPECT_EQ(compare(expectation, graded(71, 0)).size(), 1U);
    EXPECT_EQ(compare(expectation, graded(9, 0)).size(), 1U);
}

TEST(Compare, never_takes_a_failure_of_the_grader_for_a_result) {
    EXPECT_EQ(compare(Expectation(), graded(100, 10, "infra")).size(), 1U);
}

TEST(Compare, tells_of_another_verdict_and_of_an_item_that_is_not_there) {
    const Expectation expectation =
        read("full = [\"warp.cube\"]\n[verdicts]\n\"warp.disk\" = \"missing\"\n");
    EXPECT_EQ(compare(expectation, graded(90, 0, "fail")).size(), 2U);
}

TEST(Compare, wants_the_planted_mistake_first_at_an_item_that_loses) {
    const Expectation expectation = read("diagnosis = \"disk.square\"\n");
    Graded result = graded(90, 0);
    EXPECT_EQ(compare(expectation, result).size(), 1U);
    result.items[0].diagnoses = {"disk.half_radius", "disk.square"};
    EXPECT_EQ(compare(expectation, result).size(), 1U);
    EXPECT_EQ(diagnosisPlace(expectation, result), 2U);
    result.items[0].diagnoses = {"disk.square"};
    EXPECT_TRUE(compare(expectation, result).empty());
}

TEST(Compare, tells_of_a_diagnosis_at_an_item_that_must_be_full) {
    Graded result = graded(100, 10);
    result.items[0].diagnoses = {"disk.square"};
    EXPECT_EQ(compare(read("full = \"all\"\n"), result).size(), 1U);
}

TEST(ParseResults, reads_the_diagnoses_of_items_and_of_their_checks) {
    const Graded result = parseResults(R"({"submissions": [{"total": 95, "times": {"total": 2},
        "figures": [], "items": [{"id": "warp.disk", "points": 5, "max": 10, "verdict": "fail",
        "reason": "why", "diagnoses": [{"id": "disk.square", "fit": 0.9}], "checks": [
        {"id": "warp.disk.samples", "verdict": "fail", "severity": "visible", "score": 0,
         "message": "off", "diagnoses": [{"id": "disk.square"}, {"id": "disk.squared"}]},
        {"id": "warp.disk.density", "verdict": "pass", "severity": "visible", "score": 1,
         "message": "", "diagnoses": []}]}]}]})");
    ASSERT_EQ(result.items.size(), 1U);
    EXPECT_EQ(result.items[0].diagnoses, std::vector<std::string>{"disk.square"});
    ASSERT_EQ(result.items[0].checks.size(), 2U);
    EXPECT_EQ(result.items[0].checks[0].diagnoses,
              (std::vector<std::string>{"disk.square", "disk.squared"}));
    EXPECT_TRUE(result.items[0].checks[1].diagnoses.empty());
    EXPECT_THROW(parseResults("{}"), ExamError);
}

TEST(Describe, names_what_is_expected_and_what_was_lost) {
    EXPECT_EQ(describe(read("total = 100\nfull = \"all\"\n")), "100, full all");
    EXPECT_EQ(describe(read("lost = [\"warp.disk\"]\nfull = \"others\"\n")),
              "lost warp.disk, full others");
    EXPECT_EQ(describe(graded(100, 2.5)), "100: warp.disk 2.5/10");
}

TEST(ReadExpectation, refuses_what_it_does_not_know) {
    EXPECT_THROW(read("totl = 100\n"), ExamError);
    EXPECT_THROW(read("total = \"much\"\n"), ExamError);
    EXPECT_THROW(read("lost = \"some\"\n"), ExamError);
    EXPECT_THROW(read("hostile = 1\n"), ExamError);
    EXPECT_THROW(read("total = \n"), ExamError);
}

} // namespace exam
