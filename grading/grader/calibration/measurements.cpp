// SPDX-License-Identifier: MIT
#include "measurements.h"

#include <grader/error.h>
#include <grader/text_file.h>

#include <nlohmann/json.hpp>

#include <cmath>

namespace grader {

namespace {

using Json = nlohmann::json;

constexpr Verdict kVerdicts[] = {Verdict::Pass,    Verdict::Fail,       Verdict::Inconclusive,
                                 Verdict::Missing, Verdict::BuildError, Verdict::Crash,
                                 Verdict::Timeout, Verdict::Infra,      Verdict::Human};

Verdict verdictOf(const std::string &name) {
    for (const Verdict verdict : kVerdicts) {
        if (name == verdictName(verdict))
            return verdict;
    }
    throw GraderError("there is no verdict " + name);
}

} // namespace

void writeMeasurements(const std::filesystem::path &file, const std::vector<CheckResult> &checks) {
    Json list = Json::array();
    for (const CheckResult &check : checks) {
        Json diagnoses = Json::array();
        for (const Guess &guess : check.diagnoses)
            diagnoses.push_back({{"id", guess.id}, {"fit", guess.fit}});
        list.push_back({{"id", check.id},
                        {"verdict", verdictName(check.verdict)},
                        {"effect", std::isfinite(check.effect) ? Json(check.effect) : Json()},
                        {"floor", std::isfinite(check.floor) ? Json(check.floor) : Json()},
                        {"message", check.message},
                        {"diagnoses", std::move(diagnoses)}});
    }
    std::filesystem::create_directories(file.parent_path());
    writeTextFile(file, list.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::optional<std::vector<CheckResult>> readMeasurements(const std::filesystem::path &file) {
    if (!std::filesystem::exists(file))
        return std::nullopt;
    try {
        std::vector<CheckResult> checks;
        for (const Json &row : Json::parse(readTextFile(file))) {
            CheckResult check;
            check.id = row.at("id").get<std::string>();
            check.verdict = verdictOf(row.at("verdict").get<std::string>());
            check.effect = row.at("effect").is_null() ? kNoNumber : row.at("effect").get<double>();
            check.floor = row.at("floor").is_null() ? kNoNumber : row.at("floor").get<double>();
            check.message = row.at("message").get<std::string>();
            for (const Json &guess : row.at("diagnoses"))
                check.diagnoses.push_back(
                    {guess.at("id").get<std::string>(), guess.at("fit").get<double>()});
            checks.push_back(std::move(check));
        }
        return checks;
    } catch (const std::exception &) { // measured again
        return std::nullopt;
    }
}

} // namespace grader
