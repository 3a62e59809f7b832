// SPDX-License-Identifier: MIT
#include "scoring.h"

#include <algorithm>
#include <cmath>

#include "points.h"
#include "reason.h"

namespace grader {

namespace {

/// From the worst; see worseVerdict().
constexpr Verdict kWorstFirst[] = {Verdict::Missing, Verdict::BuildError,   Verdict::Crash,
                                   Verdict::Timeout, Verdict::Fail,         Verdict::Human,
                                   Verdict::Infra,   Verdict::Inconclusive, Verdict::Pass};

/// Weights of one severity: what there is and what was lost of it.
struct Share {
    double weight = 0;
    double lost = 0;
};

CheckResult outcomeOf(const RubricCheck &rule, const std::vector<CheckResult> &outcomes) {
    const auto found = std::find_if(outcomes.begin(), outcomes.end(),
                                    [&](const CheckResult &check) { return check.id == rule.id; });
    CheckResult check;
    if (found != outcomes.end())
        check = *found;
    else
        check.message = "This check was not run.";
    check.id = rule.id;
    check.severity = rule.severity;
    check.score = checkScore(rule, check.verdict, check.effect, check.floor);
    return check;
}

/// What the checks that cost say.
std::vector<Guess> diagnosesOf(const std::vector<CheckResult> &checks) {
    std::vector<Guess> all;
    for (const CheckResult &check : checks) {
        if (check.score < 1 && check.severity != Severity::Blemish)
            all.insert(all.end(), check.diagnoses.begin(), check.diagnoses.end());
    }
    return bestGuesses(all);
}

/// Fraction of the item's points that is kept.
double keptFraction(const RubricItem &item, const std::vector<CheckResult> &checks) {
    Share visible;
    Share latent;
    double ceiling = 1;
    for (std::size_t i = 0; i < checks.size(); ++i) {
        const RubricCheck &rule = item.checks[i];
        ceiling = std::min(ceiling, rule.keeps + (1 - rule.keeps) * checks[i].score);
        if (rule.severity == Severity::Blemish)
            continue;
        Share &share = rule.severity == Severity::Visible ? visible : latent;
        share.weight += rule.weight;
        share.lost += rule.weight * (1 - checks[i].score);
    }
    const double visibleLoss = visible.weight > 0 ? visible.lost / visible.weight : 0;
    const double unit = visible.weight > 0 ? visible.weight : latent.weight;
    const double latentLoss = unit > 0 ? std::min(item.latentFraction, latent.lost / unit) : 0;
    return std::clamp(1 - visibleLoss - latentLoss, 0.0, ceiling);
}

} // namespace

double checkScore(const RubricCheck &rule, Verdict verdict, double effect, double floor) {
    switch (verdict) {
    case Verdict::Pass:
    case Verdict::Inconclusive:
    case Verdict::Infra:
    case Verdict::Human:
        return 1;
    case Verdict::Missing:
    case Verdict::BuildError:
    case Verdict::Crash:
    case Verdict::Timeout:
        return 0;
    case Verdict::Fail:
        break;
    }
    const double size = std::abs(effect);
    if (std::isnan(size))
        return 0;
    if (size <= rule.tolerance)
        return 1;
    // Also where a table gives no bounds: then any proven defect is gross.
    if (size >= rule.gross || rule.tolerance <= 0)
        return 0;
    const double least = floor > rule.tolerance ? floor : rule.tolerance;
    return size <= least ? 1 : 1 - std::log(size / least) / std::log(rule.gross / least);
}

Verdict worseVerdict(Verdict a, Verdict b) {
    return *std::find_if(std::begin(kWorstFirst), std::end(kWorstFirst),
                         [=](Verdict verdict) { return verdict == a || verdict == b; });
}

ItemResult scoreItem(const RubricItem &item, const std::vector<CheckResult> &outcomes) {
    ItemResult result;
    result.id = item.id;
    result.title = item.title;
    result.max = item.points;
    result.extra = item.extra;
    result.verdict = item.checks.empty() ? Verdict::Infra : Verdict::Pass;
    for (const RubricCheck &rule : item.checks) {
        result.checks.push_back(outcomeOf(rule, outcomes));
        const CheckResult &check = result.checks.back();
        // A remark does not make an item wrong; that it could not be tested still has to be seen.
        if (rule.severity != Severity::Blemish || check.verdict == Verdict::Infra ||
            check.verdict == Verdict::Human)
            result.verdict = worseVerdict(result.verdict, check.verdict);
    }
    result.diagnoses = diagnosesOf(result.checks);
    result.points = toPoints(toHundredths(item.points * keptFraction(item, result.checks)));
    result.reason = reasonFor(item, result);
    return result;
}

double totalPoints(const Rubric &rubric, const std::vector<ItemResult> &items) {
    Hundredths mandatory = 0;
    Hundredths extras = 0;
    for (const ItemResult &item : items)
        (item.extra ? extras : mandatory) += toHundredths(item.points);
    const Hundredths cap = toHundredths(rubric.cap);
    switch (rubric.extras) {
    case ExtrasPolicy::FillToCap:
        return toPoints(std::min(cap, mandatory + extras));
    case ExtrasPolicy::OverCap:
        return toPoints(std::min(cap, mandatory) + extras);
    case ExtrasPolicy::Ignore:
        break;
    }
    return toPoints(std::min(cap, mandatory));
}

void score(const Rubric &rubric, const std::vector<CheckResult> &outcomes,
           SubmissionResult &result) {
    result.items.clear();
    for (const RubricItem &item : rubric.items)
        result.items.push_back(scoreItem(item, outcomes));
    result.cap = rubric.cap;
    result.total = totalPoints(rubric, result.items);
}

void scoreUntested(const Rubric &rubric, Verdict verdict, const std::string &reason,
                   SubmissionResult &result) {
    result.items.clear();
    for (const RubricItem &item : rubric.items) {
        ItemResult untested;
        untested.id = item.id;
        untested.title = item.title;
        untested.points = kNoNumber;
        untested.max = item.points;
        untested.extra = item.extra;
        untested.verdict = verdict;
        untested.reason = reason;
        result.items.push_back(std::move(untested));
    }
    result.cap = rubric.cap;
    result.total = kNoNumber;
}

} // namespace grader
