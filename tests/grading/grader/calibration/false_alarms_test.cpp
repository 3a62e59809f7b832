// SPDX-License-Identifier: MIT
#include <grader/build/base.h>
#include <grader/calibration/false_alarms.h>
#include <grader/error.h>
#include <grader/text_file.h>

#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>

namespace grader {

namespace {

/// One item with the checks `disk.points`, `disk.image` and `disk.density`.
Rubric rubricOf() {
    Rubric rubric;
    RubricItem item;
    item.id = "disk";
    for (const char *id : {"disk.points", "disk.image", "disk.density"}) {
        RubricCheck check;
        check.id = id;
        item.checks.push_back(check);
    }
    rubric.items = {item};
    return rubric;
}

std::vector<Check> tableOf() {
    std::vector<Check> table(3);
    table[0].id = "disk.points";
    table[0].evidence = Evidence::WarpPoints;
    table[1].id = "disk.image";
    table[1].evidence = Evidence::Images;
    table[1].locks = 3;
    table[2].id = "disk.density";
    return table;
}

std::vector<StageLevel> levelsFrom(const std::string &text) {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("levels-" + std::to_string(getpid()) + ".toml");
    writeTextFile(file, text);

    struct Remover {
        std::filesystem::path file;

        ~Remover() { std::filesystem::remove(file); }
    } const remover{file};

    return readStageLevels(file);
}

} // namespace

TEST(StageLevel, is_the_upper_limit_of_what_was_counted) {
    EXPECT_NEAR((StageLevel{Evidence::Images, "", 2995, 0}.bound()), 1e-3, 1e-6); // rule of three
    EXPECT_NEAR((StageLevel{Evidence::Images, "", 29956, 0}.bound()), 1e-4, 1e-7);
    EXPECT_GT((StageLevel{Evidence::Images, "", 30000, 3}.bound()), 1e-4);
}

TEST(ComposeBound, multiplies_three_stages_and_adds_what_can_cost) {
    const FalseAlarmBound bound = composeBound(rubricOf(), tableOf(), {}, 300);
    ASSERT_EQ(bound.parts.size(), 2U);
    EXPECT_EQ(bound.parts[0].checks, std::vector<std::string>{"disk.points"});
    EXPECT_NEAR(bound.parts[0].perHandIn, 1e-13, 1e-20);
    EXPECT_NEAR(bound.parts[1].perHandIn, 3e-13, 1e-20) << "three ways of looking";
    EXPECT_NEAR(bound.perHandIn, 4e-13, 1e-20);
    EXPECT_NEAR(bound.perClass, 1.2e-10, 1e-17);
    EXPECT_EQ(bound.unbounded, std::vector<std::string>{"disk.density"});
}

TEST(ComposeBound, takes_what_was_measured_for_every_stage) {
    const StageLevel level{Evidence::WarpPoints, "counted", 29956, 0};
    const FalseAlarmBound bound = composeBound(rubricOf(), tableOf(), {level}, 300);
    EXPECT_NEAR(bound.parts[0].perHandIn, std::pow(level.bound(), 3), 1e-20);
    EXPECT_FALSE(bound.parts[1].measured);
    const std::string text = describeBound(bound, 300);
    EXPECT_NE(text.find("0 of 29956 stages, below 0.0001 (95 %); counted"), std::string::npos)
        << text;
    EXPECT_NE(text.find("nominal levels 1e-4, 1e-4 and 1e-5, not measured"), std::string::npos);
    EXPECT_NE(text.find("not composed, as a tolerance decides and not a level: disk.density"),
              std::string::npos);
}

TEST(ComposeBound, leaves_out_what_cannot_cost) {
    Rubric rubric = rubricOf();
    rubric.items[0].checks[0].severity = Severity::Blemish;
    rubric.items[0].checks[1].weight = 0;
    EXPECT_EQ(composeBound(rubric, tableOf(), {}, 300).perHandIn, 0);
    rubric.items[0].checks[1].keeps = 0.5;
    EXPECT_GT(composeBound(rubric, tableOf(), {}, 300).perHandIn, 0);
}

TEST(ReadStageLevels, reads_ours) {
    const std::vector<StageLevel> levels =
        readStageLevels(projectFolder() / "grading/grader/calibration/stage_levels.toml");
    ASSERT_FALSE(levels.empty());
    EXPECT_EQ(levels[0].evidence, Evidence::WarpPoints);
    EXPECT_LT(levels[0].bound(), 2e-4);
}

TEST(ReadStageLevels, refuses_what_it_does_not_know) {
    const std::string row =
        "[[level]]\nevidence = \"images\"\nhow = \"so\"\nruns = 10\nrejections = 1\n";
    ASSERT_EQ(levelsFrom(row).size(), 1U);
    EXPECT_THROW(levelsFrom(row + "spare = 1\n"), GraderError);
    EXPECT_THROW(levelsFrom("[[level]]\nevidence = \"fixed\"\nhow = \"so\"\nruns = 1\n"
                            "rejections = 0\n"),
                 GraderError);
    EXPECT_THROW(levelsFrom("[[level]]\nevidence = \"images\"\nhow = \"so\"\nruns = 1\n"
                            "rejections = 2\n"),
                 GraderError);
    EXPECT_THROW(levelsFrom("[[level]\n"), GraderError);
}

} // namespace grader
