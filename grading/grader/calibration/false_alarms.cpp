// SPDX-License-Identifier: MIT
#include "false_alarms.h"

#include <grader/error.h>
#include <grader/rubric/toml_table.h>
#include <grader/text_file.h>
#include <statistics/binomial.h>
#include <statistics/triple_lock.h>

#include <fmt/format.h>

#include <algorithm>

namespace grader {

namespace {

/// In the order of Evidence.
const std::vector<std::string> kNames = {"fixed", "warp_points", "cells", "images", "noise"};

constexpr double kMostRuns = 1e12;

const char *whatOf(Evidence evidence) {
    switch (evidence) {
    case Evidence::WarpPoints:
        return "cells of a warp's points";
    case Evidence::Cells:
        return "cells of points on meshes and of directions";
    case Evidence::Images:
        return "means and tiles of images";
    case Evidence::Noise:
        return "errors of images against their noise";
    case Evidence::Fixed:
        break;
    }
    return "a fixed tolerance";
}

/// Whether a check of this kind can cost points.
bool canCost(const RubricCheck &rule) {
    return rule.severity != Severity::Blemish && (rule.weight > 0 || rule.keeps < 1);
}

StageLevel readLevel(TomlTable &table) {
    StageLevel level;
    if (const auto evidence = table.findChoice("evidence", kNames); evidence && *evidence > 0)
        level.evidence = static_cast<Evidence>(*evidence);
    else
        table.fail("evidence", "a kind of evidence that has a level is needed");
    level.how = table.text("how");
    level.runs = static_cast<std::uint64_t>(table.number("runs", 1, kMostRuns));
    level.rejections =
        static_cast<std::uint64_t>(table.number("rejections", 0, static_cast<double>(level.runs)));
    table.rejectUnknownKeys();
    return level;
}

std::string describeLevel(const FalseAlarmPart &part) {
    if (!part.measured)
        return "nominal levels 1e-4, 1e-4 and 1e-5, not measured";
    return fmt::format("measured at 1e-4 where right code is rejected most often: {} of {} stages, "
                       "below {:.2g} (95 %); {}",
                       part.measured->rejections, part.measured->runs, part.measured->bound(),
                       part.measured->how);
}

} // namespace

double StageLevel::bound() const {
    constexpr double kTwoSided = 0.1; // one side of it is 95 %
    return statistics::clopperPearson(rejections, runs, kTwoSided).upper;
}

std::vector<StageLevel> readStageLevels(const std::filesystem::path &file) {
    const toml::table table = parseToml(readTextFile(file), file.string());
    TomlTable document(table, file.string());
    std::vector<StageLevel> levels;
    for (TomlTable &row : document.tables("level"))
        levels.push_back(readLevel(row));
    document.rejectUnknownKeys();
    return levels;
}

FalseAlarmBound composeBound(const Rubric &rubric, const std::vector<Check> &table,
                             const std::vector<StageLevel> &levels, int classSize) {
    FalseAlarmBound bound;
    for (std::size_t kind = 1; kind < kNames.size(); ++kind) {
        FalseAlarmPart part;
        part.evidence = static_cast<Evidence>(kind);
        part.perLock = 1;
        for (const double level : statistics::LockConfig{}.significance)
            part.perLock *= level;
        const auto measured =
            std::find_if(levels.begin(), levels.end(),
                         [&](const StageLevel &level) { return level.evidence == part.evidence; });
        if (measured != levels.end()) {
            part.measured = *measured;
            part.perLock = measured->bound() * measured->bound() * measured->bound();
        }
        bound.parts.push_back(part);
    }
    for (const RubricItem &item : rubric.items) {
        for (const RubricCheck &rule : item.checks) {
            const auto check = std::find_if(table.begin(), table.end(),
                                            [&](const Check &row) { return row.id == rule.id; });
            if (!canCost(rule) || check == table.end())
                continue;
            if (check->evidence == Evidence::Fixed) {
                bound.unbounded.push_back(rule.id);
                continue;
            }
            FalseAlarmPart &part = bound.parts[static_cast<std::size_t>(check->evidence) - 1];
            part.checks.push_back(rule.id);
            part.locks += check->locks;
        }
    }
    for (FalseAlarmPart &part : bound.parts) {
        part.perHandIn = part.locks * part.perLock;
        bound.perHandIn += part.perHandIn;
    }
    std::erase_if(bound.parts, [](const FalseAlarmPart &part) { return part.checks.empty(); });
    bound.perClass = bound.perHandIn * classSize;
    return bound;
}

std::string describeBound(const FalseAlarmBound &bound, int classSize) {
    std::string text =
        fmt::format("false alarms: at most {:.1e} per hand-in, {:.1e} for {} hand-ins; composed of "
                    "levels of single stages, three of which must agree on fresh random numbers, "
                    "and never measured as a whole\n",
                    bound.perHandIn, bound.perClass, classSize);
    for (const FalseAlarmPart &part : bound.parts)
        text += fmt::format("  {}: {:.1e}, from {} times three stages in {} checks; {}\n",
                            whatOf(part.evidence), part.perHandIn, part.locks, part.checks.size(),
                            describeLevel(part));
    if (!bound.unbounded.empty())
        text += fmt::format("  not composed, as a tolerance decides and not a level: {}\n",
                            fmt::join(bound.unbounded, ", "));
    return text;
}

} // namespace grader
