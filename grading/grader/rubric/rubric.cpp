// SPDX-License-Identifier: MIT
#include "rubric.h"

#include <grader/digest.h>
#include <grader/error.h>

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <set>

#include "toml_table.h"

namespace grader {

namespace {

constexpr double kSchema = 1;
constexpr double kMostPoints = 10000;
constexpr double kLargestEffect = 1e6;
constexpr double kLargestWeight = 1000;
constexpr double kMostHints = 3;
constexpr std::uintmax_t kLargestFile = std::uintmax_t{1} << 20;

const std::vector<std::string> kSeverityNames = {"blemish", "latent", "visible"};
constexpr Severity kSeverities[] = {Severity::Blemish, Severity::Latent, Severity::Visible};
const std::vector<std::string> kPolicyNames = {"fill-to-cap", "over-cap", "ignore"};
constexpr ExtrasPolicy kPolicies[] = {ExtrasPolicy::FillToCap, ExtrasPolicy::OverCap,
                                      ExtrasPolicy::Ignore};
// S0 locks nothing in: a rubric cannot ask for it.
const std::vector<std::string> kLevelNames = {"S1", "S2", "S3"};
constexpr SandboxLevel kLevels[] = {SandboxLevel::S1, SandboxLevel::S2, SandboxLevel::S3};

/// Points are kept in hundredths, so that sums are exact.
double readPoints(TomlTable &table, const char *key) {
    const double points = table.number(key, 0.01, kMostPoints);
    if (std::abs(points * 100 - std::round(points * 100)) > 1e-6)
        table.fail(key, fmt::format("{} = {} has more than two decimals", key, points));
    return points;
}

CheckOverride readCheck(TomlTable table) {
    CheckOverride check;
    check.id = table.identifier("id");
    check.where = table.where("id");
    if (const auto severity = table.findChoice("severity", kSeverityNames))
        check.severity = kSeverities[*severity];
    check.weight = table.findNumber("weight", 0, kLargestWeight);
    check.tolerance = table.findNumber("tolerance", 1e-9, kLargestEffect);
    check.gross = table.findNumber("gross", 1e-9, kLargestEffect);
    check.keeps = table.findNumber("keeps", 0, 1);
    table.rejectUnknownKeys();
    return check;
}

RubricItem readItem(TomlTable table, double latentFraction) {
    RubricItem item;
    item.id = table.identifier("id");
    item.where = table.where("id");
    item.title = table.findText("title").value_or(item.id);
    item.points = readPoints(table, "points");
    item.extra = table.findFlag("extra").value_or(false);
    item.latentFraction = table.findNumber("latent_fraction", 0, 1).value_or(latentFraction);
    std::set<std::string> ids;
    for (TomlTable &check : table.tables("check")) {
        item.overrides.push_back(readCheck(std::move(check)));
        if (!ids.insert(item.overrides.back().id).second)
            throw GraderError(fmt::format("{}: [[item.check]]: id \"{}\" is there twice",
                                          item.overrides.back().where, item.overrides.back().id));
    }
    table.rejectUnknownKeys();
    return item;
}

/// Reads `[assignment]` into `rubric`. \return  the default of items' latent_fraction
double readAssignment(TomlTable table, Rubric &rubric) {
    rubric.id = table.identifier("id");
    rubric.title = table.findText("title").value_or(rubric.id);
    rubric.cap = readPoints(table, "cap");
    if (const auto policy = table.findChoice("extras", kPolicyNames))
        rubric.extras = kPolicies[*policy];
    if (const auto level = table.findChoice("min_sandbox", kLevelNames))
        rubric.minSandbox = kLevels[*level];
    if (const auto steps = table.findNumber("hints", 0, kMostHints)) {
        if (*steps != std::floor(*steps))
            table.fail("hints", fmt::format("hints = {} is no whole number of steps", *steps));
        rubric.hintSteps = static_cast<std::size_t>(*steps);
    }
    const double fraction =
        table.findNumber("latent_fraction", 0, 1).value_or(RubricItem{}.latentFraction);
    table.rejectUnknownKeys();
    return fraction;
}

} // namespace

Rubric parseRubric(const std::string &text, const std::string &name) {
    const toml::table document = parseToml(text, name);
    TomlTable root(document, name);
    root.number("schema", kSchema, kSchema);

    Rubric rubric;
    rubric.digest = sha256Hex(text);
    const double latentFraction = readAssignment(root.table("assignment"), rubric);
    std::set<std::string> ids;
    for (TomlTable &table : root.tables("item")) {
        rubric.items.push_back(readItem(std::move(table), latentFraction));
        const RubricItem &item = rubric.items.back();
        if (!ids.insert(item.id).second)
            throw GraderError(
                fmt::format("{}: [[item]]: id \"{}\" is there twice", item.where, item.id));
    }
    root.rejectUnknownKeys();
    if (rubric.items.empty())
        root.fail("", "no [[item]]: there is nothing to grade");
    return rubric;
}

Rubric readRubric(const std::filesystem::path &file) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error)
        throw GraderError(
            fmt::format("{}: cannot read the rubric: {}", file.string(), error.message()));
    if (size > kLargestFile)
        throw GraderError(fmt::format("{}: {} bytes are too many for a rubric (at most {})",
                                      file.string(), size, kLargestFile));
    std::ifstream stream(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (!stream)
        throw GraderError(fmt::format("{}: cannot read the rubric", file.string()));
    return parseRubric(text, file.string());
}

} // namespace grader
