// SPDX-License-Identifier: MIT
#include <grader/results/results_json.h>
#include <support/sample_result.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace grader {
namespace {

using Json = nlohmann::json;

RunResult runOf(SubmissionResult result) {
    return {{"0.1.0", "p2", "aa", "bb", "g++"}, {result}};
}

/// The parts of JSON Schema that our schema uses.
class SchemaChecker {
public:
    explicit SchemaChecker(Json schema) : m_schema(std::move(schema)) {}

    /// What is wrong with `value`, empty if nothing is.
    std::string check(const Json &value) const { return check(value, m_schema, "$"); }

private:
    std::string check(const Json &value, const Json &rule, const std::string &place) const {
        if (rule.contains("$ref")) {
            const std::string reference = rule["$ref"];
            return check(value, m_schema.at(Json::json_pointer(reference.substr(1))), place);
        }
        if (rule.contains("const") && value != rule["const"])
            return place + ": is not the constant";
        if (rule.contains("enum") &&
            std::find(rule["enum"].begin(), rule["enum"].end(), value) == rule["enum"].end())
            return place + ": is not one of the known values";
        if (rule.contains("type") && !hasType(value, rule["type"]))
            return place + ": has the wrong type";
        for (const auto &key : rule.value("required", Json::array())) {
            if (!value.contains(key))
                return place + ": lacks " + std::string(key);
        }
        return value.is_object() ? checkMembers(value, rule, place)
                                 : checkElements(value, rule, place);
    }

    std::string checkMembers(const Json &value, const Json &rule, const std::string &place) const {
        for (const auto &[key, member] : value.items()) {
            const Json properties = rule.value("properties", Json::object());
            const Json others = rule.value("additionalProperties", Json(true));
            std::string wrong;
            if (properties.contains(key))
                wrong = check(member, properties[key], place + "." + key);
            else if (others == false)
                wrong = place + ": has an unknown member " + key;
            else if (others.is_object())
                wrong = check(member, others, place + "." + key);
            if (!wrong.empty())
                return wrong;
        }
        return {};
    }

    std::string checkElements(const Json &value, const Json &rule, const std::string &place) const {
        if (!value.is_array() || !rule.contains("items"))
            return {};
        for (std::size_t i = 0; i < value.size(); ++i) {
            const std::string wrong =
                check(value[i], rule["items"], place + "[" + std::to_string(i) + "]");
            if (!wrong.empty())
                return wrong;
        }
        return {};
    }

    static bool hasType(const Json &value, const Json &type) {
        if (type.is_array())
            return std::any_of(type.begin(), type.end(),
                               [&](const Json &one) { return hasType(value, one); });
        const std::string name = type;
        return (name == "object" && value.is_object()) || (name == "array" && value.is_array()) ||
               (name == "string" && value.is_string()) || (name == "number" && value.is_number()) ||
               (name == "boolean" && value.is_boolean()) || (name == "null" && value.is_null());
    }

    Json m_schema;
};

SchemaChecker publishedSchema() {
    std::ifstream file(std::string(NORI_SOURCE_DIR) +
                       "/grading/grader/results/results.schema.json");
    return SchemaChecker(Json::parse(file));
}

TEST(ResultsJson, FollowsItsPublishedSchema) {
    EXPECT_EQ(publishedSchema().check(Json::parse(resultsJson(runOf(support::sampleResult())))),
              "");
    EXPECT_EQ(publishedSchema().check(Json::parse(resultsJson({}))), "");
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
}

TEST(ResultsJson, HoldsTheFactsUnderTheirNames) {
    const Json json = Json::parse(resultsJson(runOf(support::sampleResult())));
    EXPECT_EQ(json["schema"], 1);
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
