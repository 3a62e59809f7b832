// SPDX-License-Identifier: MIT
#include "judgement.h"

#include <grader/scoring/points.h>
#include <grader/scoring/scoring.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace grader {

namespace {

bool contains(const std::vector<std::string> &list, const std::string &id) {
    return std::find(list.begin(), list.end(), id) != list.end();
}

bool isFull(const ItemResult &item) {
    return toHundredths(item.points) >= toHundredths(item.max);
}

bool isDefect(Verdict verdict) {
    return verdict == Verdict::Fail || verdict == Verdict::Crash || verdict == Verdict::Timeout ||
           verdict == Verdict::Missing || verdict == Verdict::BuildError;
}

/// Why a check that found something takes no points.
std::string whyFree(const RubricItem &item, const RubricCheck &rule, const CheckResult &found) {
    if (rule.severity == Severity::Blemish)
        return "it is a blemish";
    if (rule.weight == 0)
        return "its weight is 0";
    if (found.verdict == Verdict::Fail && std::abs(found.effect) <= rule.tolerance)
        return fmt::format("its effect of {:.3g} is within the tolerance of {:g}", found.effect,
                           rule.tolerance);
    if (found.verdict == Verdict::Fail && std::abs(found.effect) <= found.floor)
        return fmt::format("its effect of {:.3g} is one that only some seeds find: all do from "
                           "{:.3g} on",
                           found.effect, found.floor);
    if (rule.severity == Severity::Latent && item.latentFraction == 0)
        return "it is latent, and latent_fraction is 0";
    return fmt::format("its part of {} points is less than a hundredth", formatPoints(item.points));
}

/// Says why a known mistake costs nothing.
std::string explainFree(const RubricItem &item, const ItemResult &result) {
    std::string reasons;
    for (std::size_t i = 0; i < result.checks.size(); ++i) {
        if (isDefect(result.checks[i].verdict))
            reasons += fmt::format("; {} finds it, but {}", item.checks[i].id,
                                   whyFree(item, item.checks[i], result.checks[i]));
    }
    if (reasons.empty())
        return fmt::format("the mistake is free: no check of {} finds it, one is missing", item.id);
    return fmt::format("the mistake is free in {}{}", item.id, reasons);
}

/// The checks that cost, for an item that should have kept everything.
std::string explainLoss(const ItemResult &result) {
    std::string reasons;
    for (const CheckResult &check : result.checks) {
        if (check.score < 1 && check.severity != Severity::Blemish)
            reasons += fmt::format("; {} ({}, effect {:.3g})", check.id, verdictName(check.verdict),
                                   check.effect);
    }
    return fmt::format("{} loses {} of {} points, and must lose nothing{}", result.id,
                       formatPoints(result.max - result.points), formatPoints(result.max), reasons);
}

} // namespace

std::vector<std::string> judgeCase(const Rubric &rubric, const CorpusCase &which,
                                   const std::vector<CheckResult> &outcomes) {
    SubmissionResult result;
    score(rubric, outcomes, result);
    std::vector<std::string> findings;
    for (std::size_t i = 0; i < rubric.items.size(); ++i) {
        const ItemResult &item = result.items[i];
        if (item.verdict == Verdict::Infra)
            findings.push_back(fmt::format("{} could not be tested: {}", item.id, item.reason));
        else if (which.isRight() && item.verdict == Verdict::Human)
            findings.push_back(fmt::format("{} is right, and someone has to look at it: {}",
                                           item.id, item.reason));
        else if (contains(which.free, item.id))
            continue;
        else if (which.isStarter) {
            if (toHundredths(item.points) > 0)
                findings.push_back(fmt::format("{} gives {} points for what was handed out",
                                               item.id, formatPoints(item.points)));
        } else if (contains(which.lost, item.id)) {
            if (isFull(item))
                findings.push_back(explainFree(rubric.items[i], item));
        } else if (!isFull(item))
            findings.push_back(explainLoss(item));
    }
    if (which.isRight() && findings.empty() &&
        toHundredths(result.total) < toHundredths(rubric.cap))
        findings.push_back(fmt::format("everything is right and gives {} of {}: the items do not "
                                       "add up to the cap",
                                       formatPoints(result.total), formatPoints(rubric.cap)));
    return findings;
}

} // namespace grader
