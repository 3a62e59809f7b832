// SPDX-License-Identifier: MIT
#include "radiance_check.h"

#include <string>
#include <utility>

namespace grader {

Check directEmsCheck(const char *name, const char *what,
                     std::function<CheckResult(CheckContext &)> run, double tolerance,
                     double gross) {
    Check check;
    check.id = std::string("direct_ems.") + name;
    check.item = "direct_ems";
    check.group = "direct_ems";
    check.what = what;
    check.tolerance = tolerance;
    check.gross = gross;
    check.run = std::move(run);
    return check;
}

Check radianceCheck(const char *name, const char *what, CaseMaker make, Experimenter experiment,
                    double gross) {
    const auto run = [=](CheckContext &context) {
        CheckResult result = judgeRadiance(context, make(context.seed("scene")));
        if (result.verdict == Verdict::Fail && experiment != nullptr) {
            std::vector<Guess> found = experiment(context);
            found.insert(found.end(), result.diagnoses.begin(), result.diagnoses.end());
            result.diagnoses = std::move(found);
        }
        return result;
    };
    Check check = directEmsCheck(name, what, run, 0.002, gross);
    check.evidence = Evidence::Images;
    check.locks = kRadianceLocks;
    return check;
}

} // namespace grader
