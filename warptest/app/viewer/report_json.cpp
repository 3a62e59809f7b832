// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include <viewer/report_json.h>

namespace viewer {

std::string reportJson(const Subject &subject, const TestReport &report) {
    const battery::TestResult &result = report.result;
    nlohmann::ordered_json json;
    json["warp"] = subject.truth->id;
    if (subject.truth->hasParameter) {
        json["parameter"] = report.settings.parameter;
    }
    json["seed"] = report.settings.seed;
    json["verdict"] = word(result.verdict);
    json["summary"] = result.headline;
    json["error"] = result.error;
    json["health"] = nlohmann::ordered_json::array();
    for (const battery::TestRow &row : result.rows) {
        json["health"].push_back({{"name", row.name},
                                  {"found", row.value},
                                  {"expected", row.expected},
                                  {"verdict", word(row.status)}});
    }
    json["remarks"] = result.remarks;
    json["power"] = result.power;
    json["observed"] = report.maps.observed;
    json["expected"] = report.maps.expected;
    return json.dump();
}

std::string documentJson(const std::vector<std::string> &reports) {
    nlohmann::ordered_json json;
    json["schema"] = "warptest";
    json["version"] = 1;
    json["tests"] = nlohmann::ordered_json::array();
    for (const std::string &report : reports) {
        json["tests"].push_back(nlohmann::ordered_json::parse(report));
    }
    return json.dump(1) + "\n";
}

} // namespace viewer
