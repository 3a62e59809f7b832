// SPDX-License-Identifier: MIT
#include "grading.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

#include "command.h"

namespace exam {

namespace {

constexpr double kRounding = 1e-9; ///< points are sums of fractions
constexpr int kDone = 0;           ///< exit codes of `norigrade grade` that are no failure
constexpr int kNeedsHuman = 3;
constexpr int kInfra = 5; ///< and the one that may be none another time

std::vector<std::string> parseGuesses(const nlohmann::json &json) {
    std::vector<std::string> ids;
    for (const nlohmann::json &guess : json)
        ids.push_back(guess.at("id").get<std::string>());
    return ids;
}

GradedItem parseItem(const nlohmann::json &json) {
    GradedItem item;
    json.at("id").get_to(item.id);
    json.at("points").get_to(item.points);
    json.at("max").get_to(item.max);
    json.at("verdict").get_to(item.verdict);
    json.at("reason").get_to(item.reason);
    item.diagnoses = parseGuesses(json.at("diagnoses"));
    for (const nlohmann::json &row : json.at("checks")) {
        GradedCheck check;
        row.at("id").get_to(check.id);
        row.at("verdict").get_to(check.verdict);
        row.at("severity").get_to(check.severity);
        row.at("score").get_to(check.score);
        row.at("message").get_to(check.message);
        check.diagnoses = parseGuesses(row.at("diagnoses"));
        item.checks.push_back(std::move(check));
    }
    return item;
}

bool isAsExpected(const GradedItem &item, Kept kept) {
    switch (kept) {
    case Kept::Any:
        return true;
    case Kept::Full:
        return item.isFull();
    case Kept::Lost:
        return !item.isFull();
    case Kept::Zero:
        return item.points <= kRounding;
    }
    return false;
}

const char *keptName(Kept kept) {
    switch (kept) {
    case Kept::Any:
        return "any";
    case Kept::Full:
        return "full";
    case Kept::Lost:
        return "lost";
    case Kept::Zero:
        return "zero";
    }
    return "?";
}

/// ` warp.disk others`, each with a blank before it.
std::string itemsThat(const Expectation &expectation, Kept kept) {
    std::string names;
    for (const auto &[id, wanted] : expectation.items) {
        if (wanted == kept)
            names += " " + id;
    }
    if (expectation.others == kept)
        names += expectation.items.empty() ? " all" : " others";
    return names;
}

void compareItem(const Expectation &expectation, const GradedItem &item,
                 std::vector<std::string> &misses) {
    const std::string got = fmt::format("{} got {:g} of {:g} ({}: {})", item.id, item.points,
                                        item.max, item.verdict, item.reason);
    const auto named = expectation.items.find(item.id);
    const Kept kept = named != expectation.items.end() ? named->second : expectation.others;
    if (!isAsExpected(item, kept))
        misses.push_back(fmt::format("{}; expected: {}", got, keptName(kept)));
    const auto verdict = expectation.verdicts.find(item.id);
    if (verdict != expectation.verdicts.end() && verdict->second != item.verdict)
        misses.push_back(fmt::format("{}; expected verdict: {}", got, verdict->second));
    if (kept == Kept::Full && !item.diagnoses.empty())
        misses.push_back(fmt::format("{} is diagnosed: {}", got, fmt::join(item.diagnoses, ", ")));
    if (item.verdict == "infra") // points are kept, but nothing was tested
        misses.push_back(got);
}

} // namespace

std::string seedOf(int round) {
    return fmt::format("{:032x}", 0x5eed0000 + round);
}

bool GradedCheck::found() const {
    return verdict != "pass" && verdict != "inconclusive" && verdict != "infra" &&
           verdict != "human";
}

bool GradedItem::isFull() const {
    return points >= max - kRounding;
}

bool GradedItem::needsHuman() const {
    return verdict == "human";
}

std::string gradeToJson(const std::filesystem::path &norigrade, const std::filesystem::path &handIn,
                        const Question &question, int jobs, const std::filesystem::path &scratch) {
    std::vector<std::string> command = {norigrade.string(),
                                        "grade",
                                        handIn.string(),
                                        "--json",
                                        "--quiet",
                                        "--seed",
                                        question.seed,
                                        "--jobs",
                                        std::to_string(jobs),
                                        "--out",
                                        (scratch / "results").string()};
    if (!question.item.empty())
        command.insert(command.end(), {"--item", question.item});
    const Outcome outcome = runCommand(command, scratch);
    if (outcome.exitCode == kDone || outcome.exitCode == kNeedsHuman)
        return outcome.output;
    const std::string what =
        fmt::format("norigrade ended with code {}: {}", outcome.exitCode, outcome.errors);
    if (outcome.exitCode == kInfra)
        throw InfraError(what);
    throw ExamError(what);
}

Graded parseResults(const std::string &json) {
    try {
        const nlohmann::json document = nlohmann::json::parse(json);
        const nlohmann::json &submission = document.at("submissions").at(0);
        Graded graded;
        submission.at("total").get_to(graded.total);
        submission.at("times").at("total").get_to(graded.seconds);
        for (const nlohmann::json &item : submission.at("items"))
            graded.items.push_back(parseItem(item));
        for (const nlohmann::json &figure : submission.at("figures"))
            graded.figures.push_back({figure.at("path").get<std::string>(),
                                      (figure.at("flag").get<bool>() ? "!" : "") +
                                          figure.at("verdict").get<std::string>(),
                                      figure.at("message").get<std::string>()});
        return graded;
    } catch (const nlohmann::json::exception &error) {
        throw ExamError(fmt::format("norigrade's JSON: {}", error.what()));
    }
}

std::vector<std::string> compare(const Expectation &expectation, const Graded &graded) {
    std::vector<std::string> misses;
    if (graded.total < expectation.minTotal - kRounding ||
        graded.total > expectation.maxTotal + kRounding)
        misses.push_back(fmt::format("the total is {:g}; expected: {:g} to {:g}", graded.total,
                                     expectation.minTotal, expectation.maxTotal));
    for (const GradedItem &item : graded.items)
        compareItem(expectation, item, misses);
    for (const auto &[path, wanted] : expectation.figures) {
        const auto found = std::find_if(
            graded.figures.begin(), graded.figures.end(),
            [&, &name = path](const GradedFigure &figure) { return figure.path == name; });
        if (found == graded.figures.end())
            misses.push_back(fmt::format("there is no figure {}", path));
        else if (found->verdict != wanted)
            misses.push_back(fmt::format("{} is {}: {}; expected: {}", path, found->verdict,
                                         found->message, wanted));
    }
    for (const auto &[id, kept] : expectation.items) {
        const bool known =
            std::any_of(graded.items.begin(), graded.items.end(),
                        [&, &wanted = id](const GradedItem &item) { return item.id == wanted; });
        if (!known)
            misses.push_back(fmt::format("there is no item {}", id));
    }
    if (!expectation.diagnosis.empty() && diagnosisPlace(expectation, graded) != 1) {
        std::vector<std::string> got;
        for (const GradedItem &item : graded.items)
            got.insert(got.end(), item.diagnoses.begin(), item.diagnoses.end());
        misses.push_back(
            fmt::format("the first diagnosis is not {}: {}", expectation.diagnosis,
                        got.empty() ? "none" : fmt::format("{}", fmt::join(got, ", "))));
    }
    return misses;
}

std::size_t diagnosisPlace(const Expectation &expectation, const Graded &graded) {
    std::size_t place = 0;
    for (const GradedItem &item : graded.items) {
        const auto found =
            std::find(item.diagnoses.begin(), item.diagnoses.end(), expectation.diagnosis);
        if (item.isFull() || found == item.diagnoses.end())
            continue;
        const auto here = static_cast<std::size_t>(found - item.diagnoses.begin()) + 1;
        place = place == 0 ? here : std::min(place, here);
    }
    return place;
}

std::string describe(const Expectation &expectation) {
    std::vector<std::string> parts;
    if (expectation.minTotal == expectation.maxTotal)
        parts.push_back(fmt::format("{:g}", expectation.minTotal));
    else if (expectation.maxTotal < 100)
        parts.push_back(fmt::format("at most {:g}", expectation.maxTotal));
    for (const Kept kept : {Kept::Lost, Kept::Zero, Kept::Full}) {
        const std::string items = itemsThat(expectation, kept);
        if (!items.empty())
            parts.push_back(keptName(kept) + items);
    }
    return fmt::format("{}", fmt::join(parts, ", "));
}

std::string describe(const Graded &graded) {
    std::string text = fmt::format("{:g}", graded.total);
    std::string separator = ": ";
    for (const GradedItem &item : graded.items) {
        if (item.isFull())
            continue;
        text += fmt::format("{}{} {:.3g}/{:g}", separator, item.id, item.points, item.max);
        separator = ", ";
    }
    return text;
}

} // namespace exam
