// SPDX-License-Identifier: MIT
#include "reason.h"

#include <grader/diagnosis/catalogue.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace grader {

namespace {

bool isDefect(Verdict verdict) {
    return verdict != Verdict::Pass && verdict != Verdict::Inconclusive &&
           verdict != Verdict::Infra && verdict != Verdict::Human;
}

std::string messageOf(const CheckResult &check) {
    return check.message.empty() ? check.id + " failed." : check.message;
}

std::size_t countIf(const ItemResult &result, bool (*matches)(const CheckResult &)) {
    return static_cast<std::size_t>(
        std::count_if(result.checks.begin(), result.checks.end(), matches));
}

bool costs(const CheckResult &check) {
    return check.severity != Severity::Blemish && isDefect(check.verdict) && check.score < 1;
}

bool isBuild(Verdict verdict) {
    return verdict == Verdict::Missing || verdict == Verdict::BuildError;
}

bool isRemark(const CheckResult &check) {
    return isDefect(check.verdict) && !costs(check);
}

/// What a lost fraction of this check weighs; visible defects are told before latent ones.
double importance(const RubricCheck &rule, const CheckResult &check) {
    const double weight = rule.severity == Severity::Visible ? 1e6 : 1;
    return (2 - rule.keeps) * weight * (1 - check.score) * std::max(rule.weight, 1e-3);
}

std::string plural(std::size_t count, const char *one, const char *many) {
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string defects(const RubricItem &item, const ItemResult &result) {
    std::size_t worst = 0;
    double most = -1;
    for (std::size_t i = 0; i < result.checks.size(); ++i) {
        if (costs(result.checks[i]) && importance(item.checks[i], result.checks[i]) > most) {
            most = importance(item.checks[i], result.checks[i]);
            worst = i;
        }
    }
    const CheckResult &check = result.checks[worst];
    std::string text = messageOf(check);
    const Diagnosis *diagnosis =
        result.diagnoses.empty() ? nullptr : findDiagnosis(result.diagnoses.front().id);
    if (diagnosis != nullptr)
        text += " " + diagnosis->in(Language::English).sentence;
    if (check.severity == Severity::Latent)
        text += " (No scene of the assignment shows this; it costs little.)";
    std::size_t others = 0;
    std::set<std::string> messages;
    for (const CheckResult &other : result.checks) {
        if (costs(other) && other.message != check.message) {
            ++others;
            messages.insert(other.message);
        }
    }
    // A file that is missing or does not compile fails many checks with the same words.
    if (messages.size() == 1 && isBuild(check.verdict))
        text += (text.back() == '.' ? " " : ". ") + *messages.begin();
    else if (others > 0)
        text += fmt::format(" And {} more.", plural(others, "check", "checks"));
    return text;
}

} // namespace

std::string reasonFor(const RubricItem &item, const ItemResult &result) {
    if (result.checks.empty())
        return "Not tested: the rubric has no checks for it.";
    if (countIf(result, costs) > 0)
        return defects(item, result);

    const auto first = [&](Verdict verdict) {
        return std::find_if(result.checks.begin(), result.checks.end(),
                            [=](const CheckResult &check) { return check.verdict == verdict; });
    };
    std::string text = "Right in everything that was tested.";
    if (const auto human = first(Verdict::Human); human != result.checks.end())
        text = "Someone has to look: " + messageOf(*human);
    else if (const auto infra = first(Verdict::Infra); infra != result.checks.end())
        text = "Not tested, through no fault of the hand-in: " + messageOf(*infra);
    else if (const auto open = first(Verdict::Inconclusive); open != result.checks.end())
        text = "Cannot be told, and so costs nothing: " + messageOf(*open);
    if (const std::size_t remarks = countIf(result, isRemark); remarks > 0)
        text += fmt::format(" {}, which costs nothing.", plural(remarks, "remark", "remarks"));
    return text;
}

} // namespace grader
