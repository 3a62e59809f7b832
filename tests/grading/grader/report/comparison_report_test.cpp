// SPDX-License-Identifier: MIT
#include <grader/report/comparison_report.h>
#include <support/schema_checker.h>

#include <gtest/gtest.h>

namespace grader {
namespace {

using Json = nlohmann::json;

const ComparedFiles kFiles{"mine.exr", {"a.exr", "b.exr"}};

Comparison sample() {
    Comparison comparison;
    comparison.likeness = Likeness::Different;
    comparison.reasons = {"R: the mean is +1 % off."};
    comparison.width = 16;
    comparison.height = 8;
    comparison.flip = 0.25;
    comparison.pValue = 1e-9;
    comparison.scaleIsUnbiased = true;
    for (const char *name : {"R", "G"}) {
        ChannelComparison channel;
        channel.name = name;
        channel.errors = {1.01, 1, 0.02, 0.0004, 0.01, 0.1};
        statistics::TileWelchResult tiles;
        for (int x : {0, 8}) {
            statistics::Tile tile{x, 0, 1, {}, 0};
            tile.test = statistics::meanTest(0.01, x == 8 ? 1e-6 : 1e-4, 0, 1e6);
            tiles.tiles.push_back(tile);
        }
        tiles.global = statistics::meanTest(0.01, 1e-6, 0, 1e6);
        tiles.referenceMean = 1;
        statistics::summarizeTiles(tiles, {});
        channel.tiles = tiles;
        channel.scale = statistics::ScaleEstimate{0.01, 0.001, 0.014, 0.007};
        channel.noise = statistics::NoiseTest{1.5, 3, 0.003};
        comparison.channels.push_back(std::move(channel));
    }
    return comparison;
}

TEST(ComparisonReport, SaysTheVerdictFirstThenWhyThenTheNumbers) {
    const std::string text = comparisonReport(kFiles, sample(), {});
    EXPECT_EQ(text.find("mine.exr against a.exr, b.exr: different\n  R: the mean is +1 % off.\n"),
              0U)
        << text;
    for (const char *part : {"RMSE                                    0.02", "+1.000 %",
                             "1.01000 +- 0.00196", "1.5000 (z +3.0)",
                             "FLIP                    "
                             "              0.2500",
                             "R  (   8,    0)"})
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
    EXPECT_NE(comparisonReport(kFiles, sample(), {.colour = true}).find("\x1b[31mdifferent"),
              std::string::npos);
}

TEST(ComparisonReport, LeavesOutWhatIsNotKnown) {
    Comparison comparison = sample();
    comparison.likeness = Likeness::CannotTell;
    comparison.pValue.reset();
    for (ChannelComparison &channel : comparison.channels) {
        channel.tiles.reset();
        channel.scale.reset();
        channel.noise.reset();
    }
    const std::string text = comparisonReport(kFiles, comparison, {});
    EXPECT_NE(text.find("cannot tell"), std::string::npos);
    for (const char *part : {"tiles", "scale", "noise", "p of all"})
        EXPECT_EQ(text.find(part), std::string::npos) << part << "\n" << text;
    EXPECT_NE(text.find("RMSE"), std::string::npos);
}

TEST(ComparisonReport, CannotBeDrivenByAFileName) {
    const std::string text = comparisonReport({"a\x1b[2Jb.exr", {"c\n.exr"}}, sample(), {});
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
    EXPECT_EQ(text.find("c\n.exr"), std::string::npos);
}

TEST(ComparisonJson, FollowsItsPublishedSchema) {
    const auto schema =
        support::SchemaChecker::ofFile("grading/grader/report/comparison.schema.json");
    Json json = Json::parse(comparisonJson(kFiles, sample()));
    EXPECT_EQ(schema.check(json), "");
    EXPECT_EQ(json["verdict"], "different");
    EXPECT_EQ(json["channels"][0]["test"]["tiles"].size(), 2U);
    json["channels"][0].erase("rmse");
    EXPECT_EQ(schema.check(json), "$.channels[0]: lacks rmse");
    Comparison none;
    none.reasons = {"The image has 1 pixel that is not finite (NaN or infinite)."};
    EXPECT_EQ(schema.check(Json::parse(comparisonJson(kFiles, none))), "");
}

} // namespace
} // namespace grader
