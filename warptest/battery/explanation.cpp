// SPDX-License-Identifier: MIT
#include <battery/battery.h>

#include <fmt/core.h>

#include <ostream>

namespace battery {

const char *label(Status status) {
    switch (status) {
    case Status::Pass:
        return "✔ pass";
    case Status::Fail:
        return "✖ fail";
    case Status::Inconclusive:
        return "▲ cannot tell";
    case Status::NotRun:
        break;
    }
    return "○ not run";
}

const char *word(Status status) {
    switch (status) {
    case Status::Pass:
        return "pass";
    case Status::Fail:
        return "fail";
    case Status::Inconclusive:
        return "inconclusive";
    case Status::NotRun:
        break;
    }
    return "not run";
}

std::string explain(const TestResult &result) {
    std::string text = fmt::format("{}: {}\n", label(result.verdict), result.headline);
    if (!result.error.empty()) {
        text += fmt::format("    {}\n", result.error);
    }
    for (const TestRow &row : result.rows) {
        text += fmt::format("    {:<26} {:<28} {:<18} {}\n", row.name, row.value, row.expected,
                            label(row.status));
    }
    for (const std::string &remark : result.remarks) {
        text += fmt::format("    - {}\n", remark);
    }
    if (!result.power.empty()) {
        text += fmt::format("    {}\n", result.power);
    }
    return text;
}

std::ostream &operator<<(std::ostream &stream, const TestResult &result) {
    return stream << explain(result);
}

} // namespace battery
