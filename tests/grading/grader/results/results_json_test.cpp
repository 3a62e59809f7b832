// SPDX-License-Identifier: MIT
#include <grader/results/results_json.h>
#include <support/sample_result.h>
#include <support/schema_checker.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace grader {
namespace {

using Json = nlohmann::json;

RunResult runOf(SubmissionResult result) {
    return {{"0.1.0", "p2", "aa", "bb", "g++"}, {result}};
}

support::SchemaChecker publishedSchema() {
    return support::SchemaChecker::ofFile("grading/grader/results/results.schema.json");
}

TEST(ResultsJson, FollowsItsPublishedSchema) {
    EXPECT_EQ(publishedSchema().check(Json::parse(resultsJson(runOf(support::sampleResult())))),
              "");
    EXPECT_EQ(publishedSchema().check(Json::parse(resultsJson({}))), "");
    EXPECT_EQ(publishedSchema().check(Json::parse(resultsJson(runOf(support::resultWithMap())))),
              "");
    for (const std::string &text : support::hostileStrings())
        EXPECT_EQ(
            publishedSchema().check(Json::parse(resultsJson(runOf(support::resultWith(text))))),
            "");
}

TEST(ResultsJson, IsRefusedByTheSchemaWhenItIsDamaged) {
    const Json right = Json::parse(resultsJson(runOf(support::sampleResult())));
    Json wrong = right;
    wrong["submissions"][0]["items"][1].erase("verdict");
    EXPECT_EQ(publishedSchema().check(wrong), "$.submissions[0].items[1]: lacks verdict");
    wrong = right;
    wrong["submissions"][0]["items"][0]["verdict"] = "passed";
    EXPECT_NE(publishedSchema().check(wrong), "");
    wrong = right;
    wrong["submissions"][0]["grade"] = 3;
    EXPECT_NE(publishedSchema().check(wrong), "");
    wrong = right;
    wrong["submissions"][0]["total"] = "3";
    EXPECT_NE(publishedSchema().check(wrong), "");
    wrong = Json::parse(resultsJson(runOf(support::resultWithMap())));
    wrong["submissions"][0]["items"][2]["checks"][0]["map"]["counts"].push_back(1);
    EXPECT_EQ(publishedSchema().check(wrong), "$.submissions[0].items[2].checks[0].map.counts: has "
                                              "the wrong number of elements");
}

TEST(ResultsJson, HoldsTheFactsUnderTheirNames) {
    const Json json = Json::parse(resultsJson(runOf(support::sampleResult())));
    EXPECT_EQ(json["schema"], 2);
    const Json &submission = json["submissions"][0];
    EXPECT_EQ(submission["name"], "p2_123456_654321");
    EXPECT_EQ(submission["members"], Json::array({"123456", "654321"}));
    EXPECT_EQ(submission["total"], 72.5);
    EXPECT_EQ(submission["cap"], 100);
    EXPECT_EQ(submission["sandbox"], "S3");
    EXPECT_EQ(submission["final"], true);
    const Json &item = submission["items"][2];
    EXPECT_EQ(item["id"], "direct_ems");
    EXPECT_EQ(item["points"], 2.5);
    EXPECT_EQ(item["max"], 20);
    EXPECT_EQ(item["extra"], false);
    EXPECT_EQ(item["verdict"], "fail");
    EXPECT_EQ(item["checks"][0]["effect"], 0.31);
    EXPECT_TRUE(item["checks"][0]["mde"].is_null());
    EXPECT_EQ(item["checks"][0]["diagnosis"], "Divide by the probability.");
}

TEST(ResultsJson, KeepsTheCountsOfAMapOfPoints) {
    const Json json = Json::parse(resultsJson(runOf(support::resultWithMap())));
    const Json &items = json["submissions"][0]["items"];
    const Json &map = items[2]["checks"][0]["map"];
    EXPECT_EQ(map["warp"], "triangle");
    EXPECT_EQ(map["points"], 2048);
    EXPECT_EQ(map["counts"][0], 2000);
    EXPECT_EQ(map["counts"].size(), 1024U);
    EXPECT_TRUE(items[0]["checks"][0]["map"].is_null());
}

TEST(ResultsJson, GivesNoPointsWhereNoneAreGiven) {
    SubmissionResult result = support::sampleResult();
    result.marked = false;
    const Json json = Json::parse(resultsJson(runOf(result)));
    EXPECT_TRUE(json["submissions"][0]["total"].is_null());
    EXPECT_TRUE(json["submissions"][0]["items"][0]["points"].is_null());
}

TEST(ResultsJson, WritesWhatIsNotFiniteAsNull) {
    SubmissionResult result = support::sampleResult();
    result.items[0].checks[0].effect = INFINITY;
    result.timing.judge = kNoNumber;
    EXPECT_EQ(resultsJson(runOf(result)).find("inf,"), std::string::npos);
    EXPECT_EQ(resultsJson(runOf(result)).find("nan"), std::string::npos);
}

TEST(ResultsJson, HasNoByteThatDrivesATerminalAndLosesNoText) {
    for (const std::string &text : support::hostileStrings()) {
        const std::string json = resultsJson(runOf(support::resultWith(text)));
        EXPECT_TRUE(std::none_of(json.begin(), json.end(), [](char c) {
            return (c >= 0 && c < ' ' && c != '\n') || c == '\x7f';
        }));
        EXPECT_EQ(json.find("\xc2\x9b"), std::string::npos);
        EXPECT_EQ(json.find("\xe2\x80\xae"), std::string::npos);
        // Bytes that are no UTF-8 are replaced; everything else comes back as it was.
        const std::string name = Json::parse(json)["submissions"][0]["name"];
        EXPECT_TRUE(name == text || name.find("\xef\xbf\xbd") != std::string::npos) << text;
    }
}

TEST(ResultsJson, DiffersBetweenTwoRunsOnlyInItsTimes) {
    SubmissionResult later = support::sampleResult();
    later.timing.total = 99;
    Json a = Json::parse(resultsJson(runOf(support::sampleResult())));
    Json b = Json::parse(resultsJson(runOf(later)));
    EXPECT_NE(a, b);
    for (Json *json : {&a, &b})
        (*json)["submissions"][0].erase("times");
    EXPECT_EQ(a, b);
}

} // namespace
} // namespace grader
