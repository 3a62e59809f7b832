// SPDX-License-Identifier: MIT
#include "verdict_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace exam {

namespace {

constexpr std::array<const char *, 3> kKinds = {"correct", "grossly wrong", "subtly wrong"};
constexpr std::array<const char *, 7> kPhases = {"ingest", "compile", "link", "sample",
                                                 "judge",  "figures", "total"};

std::vector<VerdictTime> ofKind(const std::vector<VerdictTime> &times, const char *kind) {
    std::vector<VerdictTime> chosen;
    std::copy_if(times.begin(), times.end(), std::back_inserter(chosen),
                 [&](const VerdictTime &time) { return std::strcmp(time.kind(), kind) == 0; });
    return chosen;
}

Spread phaseOf(const std::vector<VerdictTime> &times, const char *phase) {
    std::vector<double> seconds;
    for (const VerdictTime &time : times)
        seconds.push_back(time.phases.at(phase));
    return spreadOf(seconds);
}

std::vector<ItemTime> grossItems(const std::vector<VerdictTime> &times) {
    std::vector<ItemTime> items;
    for (const VerdictTime &time : times)
        std::copy_if(time.items.begin(), time.items.end(), std::back_inserter(items),
                     [](const ItemTime &item) { return item.isGross; });
    return items;
}

std::string describe(const ItemTime &item) {
    return fmt::format("{} in {}: {:.2f} s of sampling ({:.2f} s of CPU); all checks: {:.2f} s, "
                       "most of it {} ({:.2f} s)",
                       item.item, item.handIn, item.decidedWall, item.decidedCpu, item.samplingCpu,
                       item.slowest, item.slowestCpu);
}

/// `median 0.50, 95 % 1.20, most 1.30`
std::string describe(const std::vector<ItemTime> &items, double ItemTime::*figure) {
    std::vector<double> values;
    for (const ItemTime &item : items)
        values.push_back(item.*figure);
    const Spread spread = spreadOf(values);
    return fmt::format("median {:.2f}, 95 % {:.2f}, most {:.2f}", spread.median, spread.p95,
                       *std::max_element(values.begin(), values.end()));
}

std::string describeGross(const std::vector<VerdictTime> &times) {
    const std::vector<ItemTime> items = grossItems(times);
    if (items.empty())
        return "no item is grossly wrong";
    return fmt::format(
        "{} grossly wrong items, {} of them known as such only after more than {:g} "
        "s of sampling: {} s (CPU: {}); all checks of such an item: {} s (CPU: {})",
        items.size(), lateItems(times).size(), kGrossLimit, describe(items, &ItemTime::decidedWall),
        describe(items, &ItemTime::decidedCpu), describe(items, &ItemTime::samplingWall),
        describe(items, &ItemTime::samplingCpu));
}

} // namespace

Spread spreadOf(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t count = values.size();
    const auto last = static_cast<std::size_t>(std::ceil(0.95 * static_cast<double>(count)));
    return {(values[(count - 1) / 2] + values[count / 2]) / 2, values[last - 1]};
}

const char *VerdictTime::kind() const {
    if (isRight)
        return kKinds[0];
    const bool isGross =
        std::any_of(items.begin(), items.end(), [](const ItemTime &item) { return item.isGross; });
    return isGross ? kKinds[1] : kKinds[2];
}

std::vector<ItemTime> lateItems(const std::vector<VerdictTime> &times) {
    std::vector<ItemTime> items = grossItems(times);
    std::erase_if(items, [](const ItemTime &item) { return item.decidedWall <= kGrossLimit; });
    return items;
}

std::string describeTimes(const std::vector<VerdictTime> &times) {
    std::string text = fmt::format("{:<14} {:>4}", "seconds", "");
    for (const char *phase : kPhases)
        text += fmt::format(" {:>14}", phase);
    text += "\n";
    for (const char *kind : kKinds) {
        const std::vector<VerdictTime> chosen = ofKind(times, kind);
        if (chosen.empty())
            continue;
        text += fmt::format("{:<14} {:>4}", kind, chosen.size());
        for (const char *phase : kPhases) {
            const Spread spread = phaseOf(chosen, phase);
            text += fmt::format(" {:>6.2f} ({:>5.2f})", spread.median, spread.p95);
        }
        text += "\n";
    }
    text += describeGross(times) + "\n";
    for (const ItemTime &item : lateItems(times))
        text += "  " + describe(item) + "\n";
    return text;
}

std::string timesMarkdown(const std::vector<VerdictTime> &times, const std::string &commit) {
    std::string text =
        fmt::format("Measured at commit `{}`. Seconds: median (95 % take no longer).\n\n"
                    "| | hand-ins | {} |\n"
                    "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
                    commit, fmt::join(kPhases, " | "));
    for (const char *kind : kKinds) {
        const std::vector<VerdictTime> chosen = ofKind(times, kind);
        if (chosen.empty())
            continue;
        text += fmt::format("| {} | {} |", kind, chosen.size());
        for (const char *phase : kPhases) {
            const Spread spread = phaseOf(chosen, phase);
            text += fmt::format(" {:.2f} ({:.2f}) |", spread.median, spread.p95);
        }
        text += "\n";
    }
    text += fmt::format("\n{}.\n", describeGross(times));
    for (const ItemTime &item : lateItems(times))
        text += fmt::format("- {}\n", describe(item));
    return text;
}

} // namespace exam
