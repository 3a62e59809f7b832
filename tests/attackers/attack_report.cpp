// SPDX-License-Identifier: MIT
#include "attack_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <istream>
#include <ostream>

namespace attack {

using grader::SandboxLevel;

namespace {

constexpr char kArchive[] = "archive";

std::string cell(std::string text) {
    for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
        text.insert(at, "\\");
    return text;
}

template <typename Counts>
std::size_t count(const std::vector<ReportRow> &rows, const Counts &counts) {
    return static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), counts));
}

/// `S2, S3`
std::string levelsThatContain(const ReportRow &row) {
    std::string levels;
    for (const auto &[level, seen] : row.seen) {
        if (seen.contained)
            levels += (levels.empty() ? "" : ", ") + std::string(sandboxLevelName(level));
    }
    return levels.empty() ? "**none**" : levels;
}

/// What was seen, once if it was the same at all levels.
std::string whatWasSeen(const ReportRow &row) {
    const std::string &first = row.seen.begin()->second.what;
    const bool same = std::all_of(row.seen.begin(), row.seen.end(),
                                  [&](const auto &each) { return each.second.what == first; });
    if (same)
        return first;
    std::string all;
    for (const auto &[level, seen] : row.seen)
        all += fmt::format("{}{}: {}", all.empty() ? "" : "; ", sandboxLevelName(level), seen.what);
    return all;
}

} // namespace

std::string summarise(const std::vector<ReportRow> &rows, SandboxLevel level) {
    std::size_t programs[2] = {}; // of them contained, all
    std::size_t archives[2] = {};
    double gained = 0;
    Traces traces;
    for (const ReportRow &row : rows) {
        const auto seen = row.seen.find(level);
        if (seen == row.seen.end())
            continue;
        std::size_t *counts = row.group == kArchive ? archives : programs;
        counts[0] += seen->second.contained ? 1 : 0;
        ++counts[1];
        gained += std::max(0.0, seen->second.gained);
        traces += seen->second.traces;
    }
    return fmt::format("{}: {} of {} attackers and {} of {} hostile archives contained; {:g} "
                       "points gained; {}",
                       sandboxLevelName(level), programs[0], programs[1], archives[0], archives[1],
                       gained, traces.describe());
}

std::string markdown(const std::vector<ReportRow> &rows, const std::string &commit) {
    std::string text = fmt::format("Measured at commit `{}`.\n\n", commit);
    std::string groups;
    for (const char group : {'A', 'B', 'C', 'D', 'E'})
        groups += fmt::format(
            "{}{} {}", groups.empty() ? "" : ", ",
            count(rows, [&](const ReportRow &row) { return row.group == std::string(1, group); }),
            group);
    const std::size_t archives =
        count(rows, [](const ReportRow &row) { return row.group == kArchive; });
    text +=
        fmt::format("- {} attackers ({}), {} of them at compile time; {} hostile archives\n",
                    rows.size() - archives, groups,
                    count(rows, [](const ReportRow &row) { return row.atCompileTime; }), archives);
    for (const SandboxLevel level : {SandboxLevel::S3, SandboxLevel::S2})
        text += "- " + summarise(rows, level) + "\n";
    text += "\n| group | attacker | tries | contained at | seen |\n"
            "| --- | --- | --- | --- | --- |\n";
    for (const ReportRow &row : rows)
        text += fmt::format("| {} | {} | {} | {} | {} |\n", row.group, row.name, cell(row.tries),
                            levelsThatContain(row), cell(whatWasSeen(row)));
    return text;
}

void writeSeen(std::ostream &stream, const Seen &seen) {
    std::string what = seen.what;
    std::replace(what.begin(), what.end(), '\n', ' ');
    const Traces &traces = seen.traces;
    stream << fmt::format("{:d} {} {} {} {} {} {} {}\n", seen.contained, seen.gained,
                          traces.processes, traces.controlGroups, traces.mounts, traces.files,
                          traces.descriptors, what);
}

bool readSeen(std::istream &stream, Seen &seen) {
    Traces &traces = seen.traces;
    stream >> seen.contained >> seen.gained >> traces.processes >> traces.controlGroups >>
        traces.mounts >> traces.files >> traces.descriptors;
    stream.ignore(1);
    return static_cast<bool>(std::getline(stream, seen.what));
}

} // namespace attack
