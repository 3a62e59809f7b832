// SPDX-License-Identifier: MIT
#include "marks.h"

#include <grader/build/base.h>
#include <grader/engine/engine.h>
#include <grader/scoring/scoring.h>

namespace attack {

using namespace grader;

namespace {

constexpr char kItem[] = "warp.disk";

} // namespace

Marks::Marks(const Sandbox &sandbox)
    : m_sandbox(sandbox),
      m_rubric(readRubric(projectFolder() / "grading/rubrics/assignment-2.toml")) {
    std::vector<KnownCheck> known;
    for (const Check &check : checkTable())
        known.push_back({check.id, check.item, check.tolerance, check.gross});
    resolveChecks(m_rubric, known);
    m_asked = withItems(m_rubric, {kItem});
}

std::vector<CheckResult> Marks::check(CheckContext &context) const {
    std::vector<CheckResult> results;
    for (const RubricCheck &check : m_asked.items[0].checks) {
        results.push_back(findCheck(check.id)->run(context));
        results.back().id = check.id;
    }
    return results;
}

double Marks::pointsFor(const std::vector<CheckResult> &checks) const {
    return scoreItem(m_asked.items[0], checks).points;
}

double Marks::pointsFor(Verdict verdict) const {
    std::vector<CheckResult> results;
    for (const RubricCheck &check : m_asked.items[0].checks) {
        CheckResult result;
        result.id = check.id;
        result.verdict = verdict;
        results.push_back(result);
    }
    return pointsFor(results);
}

double Marks::pointsWithout(const std::string &id, std::vector<CheckResult> checks) const {
    for (CheckResult &check : checks) {
        if (check.id == id)
            check.verdict = Verdict::Missing;
    }
    return pointsFor(checks);
}

double Marks::pointsFor(const Submission &submission) const {
    EngineOptions options;
    options.seedHex = std::string(32, '1');
    options.rubric = &m_rubric;
    options.asked = &m_asked;
    Engine engine(m_sandbox, options);
    const SubmissionResult result = engine.grade(submission, [](std::string_view, double) {});
    return result.total;
}

} // namespace attack
