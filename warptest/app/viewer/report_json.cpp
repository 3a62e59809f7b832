// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include <cmath>

#include <viewer/report_json.h>

namespace viewer {

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json rowsJson(const battery::TestResult &result) {
    Json rows = Json::array();
    for (const battery::TestRow &row : result.rows) {
        rows.push_back({{"id", row.id},
                        {"name", row.name},
                        {"found", row.value},
                        {"expected", row.expected},
                        {"verdict", word(row.status)}});
    }
    return rows;
}

Json distributionJson(const battery::TestResult &result) {
    const battery::DistributionResult &found = result.distribution;
    Json tests = Json::array();
    for (const battery::HistogramTest &test : found.tests) {
        tests.push_back({{"u_bins", test.uBins},
                         {"v_bins", test.vBins},
                         {"statistic", number(test.statistic)},
                         {"degrees_of_freedom", test.degreesOfFreedom},
                         {"tolerance", number(test.tolerance)},
                         {"p", number(test.pValue)}});
    }
    return {{"points", found.total},
            {"p", number(found.pValue)},
            {"rms_error", number(found.rmsError)},
            {"rms_bound", number(found.rmsBound)},
            {"mde", number(found.mde)},
            {"tests", std::move(tests)}};
}

Json mapsJson(const battery::Maps &maps) {
    const battery::DomainMap &domain = maps.domain;
    return {{"rows", maps.side},
            {"points", maps.points},
            {"outside", maps.outside},
            {"x", {{"name", domain.xLabel}, {"low", domain.low[0]}, {"high", domain.high[0]}}},
            {"y", {{"name", domain.yLabel}, {"low", domain.low[1]}, {"high", domain.high[1]}}},
            {"observed", maps.observed},
            {"expected", maps.expected}};
}

Json testJson(const Tested &test) {
    const Subject &subject = *test.subject;
    const battery::TestResult &result = test.report.result;
    const Settings &settings = test.report.settings;
    Json json = {{"warp", subject.truth->id},
                 {"from", subject.from},
                 {"parameter", subject.truth->hasParameter ? Json(settings.parameter) : Json()},
                 {"seed", settings.seed},
                 {"samples", settings.samples},
                 {"alpha", settings.significance},
                 {"seeds", settings.repeats},
                 {"verdict", word(result.verdict)},
                 {"summary", result.headline},
                 {"error", result.error},
                 {"health", rowsJson(result)},
                 {"remarks", result.remarks},
                 {"power", result.power}};
    json["seed_p_values"] = result.seedPValues;
    // what threw has neither
    json["distribution"] = result.error.empty() ? distributionJson(result) : Json();
    json["maps"] = test.report.maps.observed.empty() ? Json() : mapsJson(test.report.maps);
    return json;
}

} // namespace

std::string documentJson(const std::vector<Tested> &tests) {
    Json json;
    json["schema"] = "warptest";
    json["version"] = 1;
    json["tool"] = NORI_VERSION;
    json["tests"] = Json::array();
    for (const Tested &test : tests) {
        json["tests"].push_back(testJson(test));
    }
    // messages come from hand-ins and may not be UTF-8
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace viewer
