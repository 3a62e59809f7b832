// SPDX-License-Identifier: MIT
#include <grader/checks/answer.h>
#include <grader/checks/light_choice.h>
#include <grader/checks/radiance_case.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "check_groups.h"

namespace grader {

namespace {

constexpr double kTolerance = 0.08; ///< relative, of a frequency that is proportional to radiance

CheckResult uniformChoice() {
    return makeResult(Verdict::Missing, "Every light is chosen with the same probability: there is "
                                        "no importance sampling of the lights.");
}

CheckResult noChoice() {
    return makeResult(Verdict::Missing,
                      "A sample does not come from one light: no light is chosen.");
}

CheckResult judgeChoice(CheckContext &context) {
    const LightChoice choice = measureChoice(context);
    if (choice.failure)
        return *choice.failure;
    if (choice.recognised < 0.99)
        return noChoice();
    if (choice.isUniform())
        return uniformChoice();
    const ChoiceLaw law = nearestLaw(choice);
    CheckResult result = makeResult(
        law.error <= kTolerance ? Verdict::Pass : Verdict::Fail,
        fmt::format("Lights are chosen in proportion to {}; the frequencies differ from it by at "
                    "most {:.2g} %.",
                    law.name, 100 * law.error));
    result.effect = law.error;
    if (law.reversed) {
        result.verdict = Verdict::Fail;
        result.effect = 1;
        result.diagnosis =
            "Dim lights are chosen more often than bright ones: is a reciprocal used "
            "as weight?";
    } else if (result.verdict == Verdict::Fail) {
        result.message = fmt::format("The lights' frequencies are not proportional to their "
                                     "radiance: they differ by up to {:.2g} %.",
                                     100 * law.error);
        result.diagnosis = "Append every light's radiance to the DiscretePDF once, normalise it "
                           "once, and sample with it.";
    }
    return result;
}

CheckResult judgeUnbiased(CheckContext &context) {
    const LightChoice choice = measureChoice(context);
    if (choice.failure)
        return *choice.failure;
    if (choice.recognised < 0.99)
        return noChoice();
    if (choice.isUniform())
        return uniformChoice();
    CheckResult result = judgeRadiance(context, choice.test);
    if (result.verdict == Verdict::Fail && result.diagnosis.empty())
        result.diagnosis = "Divide by the probability with which the light was really chosen.";
    return result;
}

Check row(const char *name, const char *what, CheckResult (*run)(CheckContext &)) {
    Check check;
    check.id = std::string("importance.") + name;
    check.item = "emitter_importance";
    check.group = "importance";
    check.what = what;
    check.tolerance = 0.01;
    check.gross = 0.3;
    check.run = run;
    return check;
}

} // namespace

std::vector<Check> importanceChecks() {
    return {
        row("choice", "direct_ems chooses lights in proportion to their radiance.", judgeChoice),
        row("unbiased", "The mean is right although lights are not chosen alike.", judgeUnbiased),
    };
}

} // namespace grader
