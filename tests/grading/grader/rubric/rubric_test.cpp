// SPDX-License-Identifier: MIT
#include <grader/error.h>
#include <grader/rubric/rubric.h>

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace grader {
namespace {

const std::string kHead = "schema = 1\n"
                          "[assignment]\n"
                          "id = \"a\"\n"
                          "cap = 100\n";

const std::string kItem = "[[item]]\n"
                          "id = \"warp.disk\"\n"
                          "points = 10\n";

std::string errorOf(const std::string &text) {
    try {
        parseRubric(text, "r.toml");
    } catch (const GraderError &error) {
        return error.what();
    }
    return "no error";
}

std::vector<KnownCheck> knownChecks() {
    return {{"warp.disk.density", "warp.disk", 0.001, 0.1},
            {"warp.disk.samples", "warp.disk", 0.002, 0.2},
            {"mesh.density", "area_light", 0.001, 0.2}};
}

TEST(Rubric, ReadsWhatIsGivenAndDocumentsTheRestByDefaults) {
    const Rubric rubric = parseRubric(kHead + kItem + "extra = true\n", "r.toml");

    EXPECT_EQ(rubric.id, "a");
    EXPECT_EQ(rubric.title, "a");
    EXPECT_EQ(rubric.cap, 100);
    EXPECT_EQ(rubric.extras, ExtrasPolicy::FillToCap);
    EXPECT_EQ(rubric.minSandbox, SandboxLevel::S2);
    EXPECT_EQ(rubric.digest.size(), 64u);
    ASSERT_EQ(rubric.items.size(), 1u);
    EXPECT_EQ(rubric.items[0].id, "warp.disk");
    EXPECT_EQ(rubric.items[0].points, 10);
    EXPECT_TRUE(rubric.items[0].extra);
    EXPECT_EQ(rubric.items[0].latentFraction, 0.25);
}

TEST(Rubric, LetsAnItemOverrideTheGlobalLatentFraction) {
    const Rubric rubric = parseRubric(kHead + "latent_fraction = 0.5\n" + kItem +
                                          "[[item]]\nid = \"b\"\npoints = 0.25\n"
                                          "latent_fraction = 0\n",
                                      "r.toml");
    EXPECT_EQ(rubric.items[0].latentFraction, 0.5);
    EXPECT_EQ(rubric.items[1].latentFraction, 0);
    EXPECT_EQ(rubric.items[1].points, 0.25);
}

struct Mistake {
    const char *name;
    std::string text;
    const char *message;
};

class RubricMistake : public testing::TestWithParam<Mistake> {};

TEST_P(RubricMistake, IsRefusedWithItsPlace) {
    EXPECT_EQ(errorOf(GetParam().text), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    All, RubricMistake,
    testing::Values(
        Mistake{"UnknownKey", kHead + "capp = 3\n" + kItem,
                "r.toml:5:1: [assignment]: unknown key \"capp\" (did you mean \"cap\"?)"},
        Mistake{"UnknownKeyInItem", kHead + kItem + "severity = 1\n",
                "r.toml:8:1: [[item]]: unknown key \"severity\" (known: id, title, points, extra, "
                "latent_fraction, check)"},
        Mistake{"UnknownTable", kHead + kItem + "[late]\nper_day = 10\n",
                "r.toml:8:2: rubric: unknown key \"late\" (known: schema, assignment, item)"},
        Mistake{"DuplicateItem", kHead + kItem + kItem,
                "r.toml:9:6: [[item]]: id \"warp.disk\" is there twice"},
        Mistake{"DuplicateCheck",
                kHead + kItem + "[[item.check]]\nid = \"c\"\n[[item.check]]\nid = \"c\"\n",
                "r.toml:11:6: [[item.check]]: id \"c\" is there twice"},
        Mistake{"NegativePoints", kHead + "[[item]]\nid = \"b\"\npoints = -1\n",
                "r.toml:7:10: [[item]]: points = -1 is out of range, must be from 0.01 to 10000"},
        Mistake{"NaNPoints", kHead + "[[item]]\nid = \"b\"\npoints = nan\n",
                "r.toml:7:10: [[item]]: points = nan is out of range, must be from 0.01 to 10000"},
        Mistake{"ThirdDecimal", kHead + "[[item]]\nid = \"b\"\npoints = 0.125\n",
                "r.toml:7:10: [[item]]: points = 0.125 has more than two decimals"},
        Mistake{"TextForNumber", kHead + "[[item]]\nid = \"b\"\npoints = \"10\"\n",
                "r.toml:7:10: [[item]]: points must be a number"},
        Mistake{"NumberForText", kHead + "[[item]]\nid = 3\npoints = 1\n",
                "r.toml:6:6: [[item]]: id must be a text in quotes"},
        Mistake{"NumberForFlag", kHead + kItem + "extra = 1\n",
                "r.toml:8:9: [[item]]: extra must be true or false"},
        Mistake{"OddIdentifier", kHead + "[[item]]\nid = \"a b\"\npoints = 1\n",
                "r.toml:6:6: [[item]]: id = \"a b\" may hold only a-z, 0-9, '.', '_' and '-'"},
        Mistake{"UnknownSeverity",
                kHead + kItem + "[[item.check]]\nid = \"c\"\nseverity = \"mild\"\n",
                "r.toml:10:12: [[item.check]]: severity = \"mild\" is unknown (known: blemish, "
                "latent, visible)"},
        Mistake{"UnknownPolicy", kHead + "extras = \"all\"\n" + kItem,
                "r.toml:5:10: [assignment]: extras = \"all\" is unknown (known: fill-to-cap, "
                "over-cap, ignore)"},
        Mistake{"TooManyHints", kHead + "hints = 4\n" + kItem,
                "r.toml:5:9: [assignment]: hints = 4 is out of range, must be from 0 to 3"},
        Mistake{"HalfAHint", kHead + "hints = 1.5\n" + kItem,
                "r.toml:5:9: [assignment]: hints = 1.5 is no whole number of steps"},
        Mistake{"NoSandbox", kHead + "min_sandbox = \"S0\"\n" + kItem,
                "r.toml:5:15: [assignment]: min_sandbox = \"S0\" is unknown (known: S1, S2, S3)"},
        Mistake{"NoItems", kHead, "r.toml:1:1: rubric: no [[item]]: there is nothing to grade"},
        Mistake{"NoPoints", kHead + "[[item]]\nid = \"b\"\n",
                "r.toml:5:1: [[item]]: points is missing"},
        Mistake{"NoAssignment", "schema = 1\n", "r.toml:1:1: rubric: [assignment] is missing"},
        Mistake{"Empty", "", "r.toml:1:1: rubric: schema is missing"},
        Mistake{"NewerSchema", "schema = 2\n",
                "r.toml:1:10: rubric: schema = 2 is out of range, must be from 1 to 1"},
        Mistake{"ItemIsNoArray", kHead + "[item]\nid = \"b\"\n",
                "r.toml:5:1: rubric: item must be an array of tables: [[item]]"}),
    [](const testing::TestParamInfo<Mistake> &row) { return row.param.name; });

TEST(Rubric, SaysWhereItIsNoToml) {
    EXPECT_EQ(errorOf("schema = = 1\n").substr(0, 11), "r.toml:1:10");
    EXPECT_EQ(errorOf(kHead + "cap = 3\n").substr(0, 9), "r.toml:5:");
}

TEST(Rubric, SurvivesArbitraryBytes) {
    // 2,000 damaged copies of a right rubric, fixed seed: each is read or refused, never a crash.
    std::mt19937 random(7);
    const std::string right = kHead + kItem + "[[item.check]]\nid = \"c\"\nweight = 2\n";
    for (int round = 0; round < 2000; ++round) {
        std::string text = right;
        for (int i = 0; i < 3; ++i)
            text[random() % text.size()] = static_cast<char>(random() % 256);
        EXPECT_NO_FATAL_FAILURE(errorOf(text));
    }
}

TEST(Rubric, NamesAFileThatIsNotThere) {
    EXPECT_THROW(readRubric("/nonexistent/rubric.toml"), GraderError);
    EXPECT_THROW(readRubric("/"), GraderError);
}

TEST(ResolveChecks, GivesAnItemTheTablesChecksWithTheRubricsChanges) {
    Rubric rubric = parseRubric(kHead + kItem +
                                    "[[item.check]]\nid = \"warp.disk.samples\"\nweight = 3\n"
                                    "gross = 0.5\nseverity = \"latent\"\nkeeps = 0.5\n",
                                "r.toml");
    resolveChecks(rubric, knownChecks());

    const std::vector<RubricCheck> &checks = rubric.items[0].checks;
    ASSERT_EQ(checks.size(), 2u);
    EXPECT_EQ(checks[0].id, "warp.disk.density");
    EXPECT_EQ(checks[0].weight, 1);
    EXPECT_EQ(checks[0].tolerance, 0.001);
    EXPECT_EQ(checks[0].gross, 0.1);
    EXPECT_EQ(checks[0].severity, Severity::Visible);
    EXPECT_EQ(checks[0].keeps, 1);
    EXPECT_EQ(checks[1].weight, 3);
    EXPECT_EQ(checks[1].tolerance, 0.002);
    EXPECT_EQ(checks[1].gross, 0.5);
    EXPECT_EQ(checks[1].severity, Severity::Latent);
    EXPECT_EQ(checks[1].keeps, 0.5);
}

std::string resolveError(const std::string &text) {
    Rubric rubric = parseRubric(text, "r.toml");
    try {
        resolveChecks(rubric, knownChecks());
    } catch (const GraderError &error) {
        return error.what();
    }
    return "no error";
}

TEST(ResolveChecks, RefusesWhatTheTableDoesNotHave) {
    EXPECT_EQ(resolveError(kHead + kItem + "[[item.check]]\nid = \"warp.disk.densty\"\n"),
              "r.toml:9:6: there is no check \"warp.disk.densty\" (did you mean "
              "\"warp.disk.density\"?)");
    EXPECT_EQ(resolveError(kHead + kItem + "[[item.check]]\nid = \"mesh.density\"\n"),
              "r.toml:9:6: check \"mesh.density\" belongs to item \"area_light\", not "
              "\"warp.disk\"");
    EXPECT_EQ(resolveError(kHead + "[[item]]\nid = \"warp.disc\"\npoints = 1\n"),
              "r.toml:6:6: no check judges an item \"warp.disc\" (did you mean \"warp.disk\"?)");
    EXPECT_EQ(resolveError(kHead + kItem +
                           "[[item.check]]\nid = \"warp.disk.density\"\n"
                           "tolerance = 0.1\n"),
              "r.toml:9:6: warp.disk.density: tolerance 0.1 must be below gross 0.1");
}

TEST(Summary, AddsUpTheAssignmentsRubric) {
    const Rubric rubric =
        readRubric(std::string(NORI_SOURCE_DIR) + "/grading/rubrics/assignment-2.toml");
    const RubricSummary summary = summarize(rubric);

    EXPECT_EQ(summary.text, "mandatory 90, extras 30, cap 100, extras fill to the cap");
    ASSERT_EQ(summary.warnings.size(), 2u);
    EXPECT_EQ(summary.warnings[0], "mandatory items alone give 90: 100 takes 10 points of extras");
    EXPECT_EQ(summary.warnings[1],
              "of 30 points of extras, 10 count for who has all mandatory points");
}

TEST(WithItems, LeavesTheItemsThatAreNamed) {
    const Rubric rubric =
        readRubric(std::string(NORI_SOURCE_DIR) + "/grading/rubrics/assignment-2.toml");
    EXPECT_EQ(withItems(rubric, {}).items.size(), rubric.items.size());
    const Rubric part = withItems(rubric, {"area_light", "warp.sphere"});
    ASSERT_EQ(part.items.size(), 2u);
    EXPECT_EQ(part.items[0].id, "warp.sphere");
    EXPECT_EQ(part.cap, 40);
}

TEST(WithItems, TellsOfAnItemThatIsNotThere) {
    Rubric rubric = parseRubric(kHead + kItem, "r.toml");
    rubric.items[0].id = "warp.disk";
    try {
        withItems(rubric, {"warp.disc"});
        FAIL() << "taken";
    } catch (const GraderError &error) {
        EXPECT_NE(std::string(error.what()).find("\"warp.disk\""), std::string::npos)
            << error.what();
    }
}

TEST(Summary, HasThePointsThatTheHandoutGives) {
    const Rubric rubric =
        readRubric(std::string(NORI_SOURCE_DIR) + "/grading/rubrics/assignment-2.toml");
    const std::vector<std::pair<std::string, double>> expected = {
        {"warp.triangle", 10},  {"warp.sphere", 10},
        {"warp.hemisphere", 5}, {"warp.cosine_hemisphere", 5},
        {"warp.beckmann", 10},  {"warp.disk", 10},
        {"direct_ems", 20},     {"emitter_importance", 10},
        {"area_light", 30},     {"environment_light", 10}};
    ASSERT_EQ(rubric.items.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(rubric.items[i].id, expected[i].first);
        EXPECT_EQ(rubric.items[i].points, expected[i].second);
    }
}

TEST(Summary, WarnsWhenTheCapIsOutOfReachOrPointsAreLost) {
    Rubric rubric = parseRubric(kHead + kItem, "r.toml");
    EXPECT_EQ(summarize(rubric).warnings,
              std::vector<std::string>{"all items together are worth 10: nobody can reach 100"});
    rubric.cap = 5;
    EXPECT_EQ(summarize(rubric).warnings,
              std::vector<std::string>{"mandatory items are worth 10, of which only 5 can count"});
    rubric.items[0].extra = true;
    rubric.extras = ExtrasPolicy::Ignore;
    EXPECT_EQ(summarize(rubric).warnings.back(), "10 points of extras are never given");
}

} // namespace
} // namespace grader
