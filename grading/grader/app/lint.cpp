// SPDX-License-Identifier: MIT
#include <grader/app/load_rubric.h>
#include <grader/app/terminal.h>
#include <grader/app/verbs.h>
#include <grader/diagnosis/catalogue.h>
#include <grader/error.h>
#include <grader/results/safe_text.h>
#include <grader/scoring/points.h>

#include <fmt/core.h>

namespace grader {

namespace {

void print(const RubricItem &item) {
    fmt::print("{}  {}{}\n", item.id, formatPoints(item.points), item.extra ? " (extra)" : "");
    for (const RubricCheck &check : item.checks)
        fmt::print("  {:<34} {:<8} weight {:g}  {:g} to {:g}{}\n", check.id,
                   severityName(check.severity), check.weight, check.tolerance, check.gross,
                   check.keeps < 1 ? fmt::format("  keeps {}", check.keeps) : "");
}

} // namespace

ExitCode run(const LintCommand &command) {
    try {
        const Rubric rubric = loadRubric(command.rubric);
        for (const RubricItem &item : rubric.items)
            print(item);
        const RubricSummary summary = summarize(rubric);
        fmt::print("\n{}\n", summary.text);
        fmt::print("students are shown {} of {} hints per mistake\n", rubric.hintSteps, kHintSteps);
        for (const std::string &warning : summary.warnings)
            fmt::print("warning: {}\n", safeLine(warning));
        return ExitCode::Done;
    } catch (const GraderError &error) {
        complain(error.what());
        return ExitCode::Usage;
    }
}

} // namespace grader
