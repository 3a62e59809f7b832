// SPDX-License-Identifier: MIT
#pragma once

#include <grader/checks/check.h>
#include <grader/rubric/rubric.h>
#include <grader/sandbox/box.h>
#include <grader/submission/submission.h>

namespace attack {

/// What the assignment's own rubric and checks give for the uniform disk, which is what every
/// attacker pretends to hand in.
class Marks {
public:
    /// \throws GraderError  without the rubric
    explicit Marks(const grader::Sandbox &sandbox);

    /// Runs all checks of the item on what answers.
    std::vector<grader::CheckResult> check(grader::CheckContext &context) const;

    double pointsFor(const std::vector<grader::CheckResult> &checks) const;
    /// If every check ends like that.
    double pointsFor(grader::Verdict verdict) const;

    /// What would be left if the check `id` had failed altogether: the honest part of a program
    /// that cheats there only.
    double pointsWithout(const std::string &id, std::vector<grader::CheckResult> checks) const;

    /// Builds and grades a hand-in as `norigrade grade --items warp.disk` does.
    double pointsFor(const grader::Submission &submission) const;

private:
    const grader::Sandbox &m_sandbox;
    grader::Rubric m_rubric;
    grader::Rubric m_asked; ///< only the item
};

} // namespace attack
