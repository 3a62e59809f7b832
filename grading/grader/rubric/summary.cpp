// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "rubric.h"

namespace grader {

namespace {

const char *policyText(ExtrasPolicy policy) {
    switch (policy) {
    case ExtrasPolicy::FillToCap:
        return "extras fill to the cap";
    case ExtrasPolicy::OverCap:
        return "extras count above the cap";
    case ExtrasPolicy::Ignore:
        break;
    }
    return "extras are ignored";
}

/// Sum of points, free of the rounding of decimal fractions.
double sumOf(const Rubric &rubric, bool extra) {
    double hundredths = 0;
    for (const RubricItem &item : rubric.items)
        hundredths += item.extra == extra ? std::round(item.points * 100) : 0;
    return hundredths / 100;
}

void warnOfSums(const Rubric &rubric, double mandatory, double extras,
                std::vector<std::string> &warnings) {
    const double cap = rubric.cap;
    if (mandatory > cap)
        warnings.push_back(fmt::format("mandatory items are worth {}, of which only {} can count",
                                       mandatory, cap));
    if (rubric.extras == ExtrasPolicy::FillToCap && mandatory < cap) {
        if (mandatory + extras < cap)
            warnings.push_back(fmt::format("all items together are worth {}: nobody can reach {}",
                                           mandatory + extras, cap));
        else
            warnings.push_back(
                fmt::format("mandatory items alone give {}: {} takes {} points of extras",
                            mandatory, cap, cap - mandatory));
    }
    if (rubric.extras == ExtrasPolicy::FillToCap && extras > 0 && mandatory + extras > cap)
        warnings.push_back(
            fmt::format("of {} points of extras, {} count for who has all mandatory points", extras,
                        std::max(0.0, cap - mandatory)));
    if (rubric.extras != ExtrasPolicy::FillToCap && mandatory < cap)
        warnings.push_back(
            fmt::format("mandatory items are worth {}: nobody can reach the cap of {} with them",
                        mandatory, cap));
    if (rubric.extras == ExtrasPolicy::Ignore && extras > 0)
        warnings.push_back(fmt::format("{} points of extras are never given", extras));
}

void warnOfItem(const RubricItem &item, std::vector<std::string> &warnings) {
    const auto counts = [](const RubricCheck &check) {
        return check.severity == Severity::Visible && check.weight > 0;
    };
    if (!item.checks.empty() && std::none_of(item.checks.begin(), item.checks.end(), counts))
        warnings.push_back(
            fmt::format("{}: no check is visible and has a weight: at most {} of its {} points can "
                        "be lost",
                        item.id, item.points * item.latentFraction, item.points));
    for (const RubricCheck &check : item.checks) {
        if (check.keeps < 1 && check.severity != Severity::Visible)
            warnings.push_back(fmt::format(
                "{}: keeps {}, and so it can cost {:.0f} % of the item although it is not visible",
                check.id, check.keeps, 100 * (1 - check.keeps)));
        if (check.weight == 0 && check.keeps == 1 && check.severity != Severity::Blemish)
            warnings.push_back(fmt::format("{}: weight 0, so it costs nothing", check.id));
    }
}

} // namespace

RubricSummary summarize(const Rubric &rubric) {
    const double mandatory = sumOf(rubric, false);
    const double extras = sumOf(rubric, true);
    RubricSummary summary;
    summary.text = fmt::format("mandatory {}, extras {}, cap {}, {}", mandatory, extras, rubric.cap,
                               policyText(rubric.extras));
    warnOfSums(rubric, mandatory, extras, summary.warnings);
    for (const RubricItem &item : rubric.items)
        warnOfItem(item, summary.warnings);
    return summary;
}

} // namespace grader
