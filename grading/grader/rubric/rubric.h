// SPDX-License-Identifier: MIT
#pragma once

#include <grader/results/results.h>
#include <grader/sandbox/box.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace grader {

/// How much one check counts within its item.
struct RubricCheck {
    std::string id;
    Severity severity = Severity::Visible;
    double weight = 1;    ///< relative to the other visible checks of the item, >= 0
    double tolerance = 0; ///< effect up to which nothing is lost
    double gross = 0;     ///< effect from which all is lost; log-linear in between
    double keeps = 1;     ///< most that is left of the item where this check fails altogether
};

/// What a rubric says of one check; the rest is RubricCheck's and the check table's default.
struct CheckOverride {
    std::string id;
    std::string where; ///< `file:line:column` of its id
    std::optional<Severity> severity;
    std::optional<double> weight;
    std::optional<double> tolerance;
    std::optional<double> gross;
    std::optional<double> keeps;
};

struct RubricItem {
    std::string id;
    double points = 0; ///< a whole number of hundredths
    bool extra = false;
    std::string title;
    double latentFraction = 0.25;    ///< most that latent defects may cost of this item
    std::vector<RubricCheck> checks; ///< filled in by resolveChecks(), in the table's order
    std::vector<CheckOverride> overrides;
    std::string where; ///< `file:line:column` of its id
};

enum class ExtrasPolicy {
    FillToCap, ///< extras make up for lost mandatory points, up to the cap
    OverCap,   ///< extras count on top of the cap
    Ignore,    ///< extras are tested but give no points
};

/// A rubric as read from TOML.
struct Rubric {
    std::string id;
    std::string title;
    double cap = 100;
    ExtrasPolicy extras = ExtrasPolicy::FillToCap;
    SandboxLevel minSandbox = SandboxLevel::S2;
    std::size_t hintSteps = 1; ///< of each diagnosis' ladder that students are shown [0, 3]
    std::vector<RubricItem> items;
    std::string digest; ///< SHA-256 of the file
};

/// Reads the file as far as it can be read without the check table: see resolveChecks().
/// \throws GraderError  with file:line:column and the nearest known key, on anything unknown,
///                      missing, repeated or out of range
Rubric readRubric(const std::filesystem::path &file);

/// Same, from text. \param name  of the file, for messages
Rubric parseRubric(const std::string &text, const std::string &name);

/// What a rubric has to know of a row of the check table.
struct KnownCheck {
    std::string id;
    std::string item;
    double tolerance = 0;
    double gross = 0;
};

/// Gives each item the checks of the table that name it, with the rubric's changes. An item that is
/// not in the rubric is not graded, and its checks are not run.
/// \throws GraderError  with file:line:column, on a check that is not in the table or belongs to
///                      another item, bounds that cross, and an item without a check
void resolveChecks(Rubric &rubric, const std::vector<KnownCheck> &table);

/// The rubric with only these items, in its own order, and a cap that they can reach; all of it if
/// `ids` is empty.
/// \throws GraderError  with the nearest known item, if there is no such item
Rubric withItems(const Rubric &rubric, const std::vector<std::string> &ids);

/// How a rubric adds up.
struct RubricSummary {
    std::string text; ///< `mandatory 90, extras 30, cap 100, extras fill to the cap`
    std::vector<std::string> warnings; ///< what its author may not have meant
};

RubricSummary summarize(const Rubric &rubric);

} // namespace grader
