// SPDX-License-Identifier: MIT
#include "radiance_check.h"

#include <string>
#include <utility>

namespace grader {

Check radianceCheck(const char *name, const char *what, CaseMaker make, Experimenter experiment,
                    double gross) {
    Check check;
    check.id = std::string("direct_ems.") + name;
    check.item = "direct_ems";
    check.group = "direct_ems";
    check.what = what;
    check.tolerance = 0.002;
    check.gross = gross;
    check.evidence = Evidence::Images;
    check.locks = kRadianceLocks;
    check.run = [=](CheckContext &context) {
        CheckResult result = judgeRadiance(context, make(context.seed("scene")));
        if (result.verdict == Verdict::Fail && experiment != nullptr) {
            std::vector<Guess> found = experiment(context);
            found.insert(found.end(), result.diagnoses.begin(), result.diagnoses.end());
            result.diagnoses = std::move(found);
        }
        return result;
    };
    return check;
}

} // namespace grader
