// SPDX-License-Identifier: MIT
#include "stability.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace exam {

namespace {

constexpr double kRounding = 1e-6;
constexpr double kAllowedDeviation = 0.5; ///< of a borderline hand-in's points

const char *standingName(Standing standing) {
    switch (standing) {
    case Standing::Accepted:
        return "accepted";
    case Standing::Borderline:
        return "borderline";
    case Standing::Wrong:
        return "wrong";
    }
    return "?";
}

/// `direct_ems.radiance: 58 fail, 2 pass; ...`
std::string describeChanging(const StabilityRecord &record) {
    std::vector<std::string> checks;
    for (const auto &[id, counts] : record.changingChecks()) {
        std::vector<std::string> verdicts;
        for (const auto &[verdict, count] : counts)
            verdicts.push_back(fmt::format("{} {}", count, verdict));
        checks.push_back(fmt::format("{}: {}", id, fmt::join(verdicts, ", ")));
    }
    return fmt::format("{}", fmt::join(checks, "; "));
}

/// Changes between the seeds and a second setting, and how many gradings were compared.
struct Comparison {
    std::size_t gradings = 0;
    int harmless = 0;
    std::vector<std::string> others;
};

Comparison compare(const std::vector<Graded> &seeds, const std::vector<Graded> &again,
                   bool exactly) {
    Comparison result;
    result.gradings = again.size();
    for (std::size_t i = 0; i < again.size(); ++i) {
        for (const VerdictChange &change : verdictChanges(seeds.at(i), again[i], exactly)) {
            if (change.isHarmless())
                ++result.harmless;
            else
                result.others.push_back(fmt::format("{} with seed {}: {}, then {}", change.check, i,
                                                    change.before, change.after));
        }
    }
    return result;
}

std::string describe(const Comparison &comparison) {
    if (comparison.gradings == 0)
        return "not run";
    std::string text = comparison.others.empty()
                           ? fmt::format("same in {}", comparison.gradings)
                           : fmt::format("{}", fmt::join(comparison.others, "; "));
    if (comparison.harmless > 0)
        text += fmt::format(" ({} times pass and inconclusive)", comparison.harmless);
    return text;
}

Comparison onTwo(const StabilityRecord &record) {
    return compare(record.seeds, record.pairs, true);
}

Comparison unoptimised(const StabilityRecord &record) {
    return compare(record.seeds, record.plain, false);
}

} // namespace

double StabilityRecord::points(const Graded &graded) {
    double sum = 0;
    for (const GradedItem &item : graded.items)
        sum += item.points;
    return sum;
}

double StabilityRecord::smallest() const {
    double least = seeds.empty() ? 0 : points(seeds.front());
    for (const Graded &graded : seeds)
        least = std::min(least, points(graded));
    return least;
}

double StabilityRecord::largest() const {
    double most = 0;
    for (const Graded &graded : seeds)
        most = std::max(most, points(graded));
    return most;
}

double StabilityRecord::standardDeviation() const {
    const auto count = static_cast<double>(seeds.size());
    if (count < 2)
        return 0;
    double mean = 0;
    for (const Graded &graded : seeds)
        mean += points(graded) / count;
    double sum = 0;
    for (const Graded &graded : seeds)
        sum += (points(graded) - mean) * (points(graded) - mean);
    return std::sqrt(sum / (count - 1));
}

std::map<std::string, VerdictCounts> StabilityRecord::changingChecks() const {
    std::map<std::string, VerdictCounts> all;
    for (const Graded &graded : seeds) {
        for (const GradedItem &item : graded.items) {
            for (const GradedCheck &check : item.checks)
                ++all[check.id][check.verdict];
        }
    }
    std::erase_if(all, [](const auto &entry) { return entry.second.size() < 2; });
    return all;
}

bool StabilityRecord::asExpected() const {
    const bool steady = standing == Standing::Borderline ? standardDeviation() <= kAllowedDeviation
                                                         : largest() - smallest() <= kRounding;
    const auto isFull = [](const Graded &graded) {
        return std::all_of(graded.items.begin(), graded.items.end(),
                           [](const GradedItem &item) { return item.isFull(); });
    };
    const bool full = std::all_of(seeds.begin(), seeds.end(), isFull);
    const bool lost = std::none_of(seeds.begin(), seeds.end(), isFull);
    const bool deserved = standing == Standing::Accepted ? full
                          : standing == Standing::Wrong  ? lost
                                                         : true;
    return steady && deserved && onTwo(*this).others.empty() && unoptimised(*this).others.empty();
}

bool VerdictChange::isHarmless() const {
    const auto costsNothing = [](const std::string &verdict) {
        return verdict == "pass" || verdict == "inconclusive";
    };
    return costsNothing(before) && costsNothing(after) && before != after;
}

std::vector<VerdictChange> verdictChanges(const Graded &before, const Graded &after, bool exactly) {
    const auto checksOf = [](const Graded &graded) {
        std::map<std::string, GradedCheck> checks;
        for (const GradedItem &item : graded.items) {
            for (const GradedCheck &check : item.checks)
                checks[check.id] = check;
        }
        return checks;
    };
    const std::map<std::string, GradedCheck> then = checksOf(after);
    std::vector<VerdictChange> changes;
    for (const auto &[id, check] : checksOf(before)) {
        const auto found = then.find(id);
        if (found == then.end())
            changes.push_back({id, check.verdict, "not run"});
        else if (found->second.verdict != check.verdict)
            changes.push_back({id, check.verdict, found->second.verdict});
        else if (exactly && found->second.message != check.message)
            changes.push_back({id, check.message, found->second.message});
    }
    return changes;
}

std::string describeStability(const std::vector<StabilityRecord> &records) {
    std::string text;
    for (const StabilityRecord &record : records) {
        text += fmt::format("{:<40} {:<10} {:<4} {} seeds: {:g} to {:g} points, deviation {:.2f}\n",
                            record.name, standingName(record.standing),
                            record.asExpected() ? "ok" : "MISS", record.seeds.size(),
                            record.smallest(), record.largest(), record.standardDeviation());
        if (const std::string changing = describeChanging(record); !changing.empty())
            text += fmt::format("    {}\n", changing);
        text += fmt::format("    two processes: {}\n    -O0: {}\n", describe(onTwo(record)),
                            describe(unoptimised(record)));
    }
    return text;
}

std::string stabilityMarkdown(const std::vector<StabilityRecord> &records,
                              const std::string &commit) {
    std::string text = fmt::format(
        "Measured at commit `{}`.\n\n"
        "| hand-in | | seeds | points | standard deviation | checks that do not always say the "
        "same | two processes | `-O0` |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- |\n",
        commit);
    for (const StabilityRecord &record : records) {
        const std::string name =
            record.what.empty() ? record.name : fmt::format("{}: {}", record.name, record.what);
        const std::string points =
            record.largest() - record.smallest() <= kRounding
                ? fmt::format("{:g}", record.largest())
                : fmt::format("{:g} to {:g}", record.smallest(), record.largest());
        text += fmt::format("| {} | {} | {} | {} | {:.2f} | {} | {} | {} |\n", name,
                            standingName(record.standing), record.seeds.size(), points,
                            record.standardDeviation(), describeChanging(record),
                            describe(onTwo(record)), describe(unoptimised(record)));
    }
    return text;
}

} // namespace exam
