// SPDX-License-Identifier: MIT
#include <grader/checks/image_scene.h>
#include <statistics/binomial.h>
#include <statistics/random.h>

#include <fmt/core.h>

#include "contexts.h"
#include "planted.h"
#include "runs.h"

namespace calibration {

namespace {

using grader::CheckResult;
using grader::Verdict;

struct Ends {
    int fail = 0, pass = 0, open = 0;
    double mde = 0; ///< of the last look, largest channel, mean over the judgements
};

Ends judge(const Recording &student, const Recording &ours, int judgements, std::uint64_t seed) {
    Ends ends;
    for (int i = 0; i < judgements; ++i) {
        RecordedContext context(
            student, ours, statistics::deriveSeed(seed, "judgement", 0, static_cast<unsigned>(i)));
        const CheckResult result = grader::judgeRadiance(context, grader::imageCase({}, 256));
        ends.fail += result.verdict == Verdict::Fail ? 1 : 0;
        ends.pass += result.verdict == Verdict::Pass ? 1 : 0;
        ends.open += result.verdict == Verdict::Inconclusive ? 1 : 0;
        ends.mde += result.mde / judgements;
    }
    return ends;
}

/// Whether mistakes that must be found were: in 99.9 % of the judgements, within the binomial
/// 99.9 % limits.
bool isKept(Asked asked, int fail, int judgements) {
    if (asked == Asked::Nothing)
        return true;
    if (asked == Asked::NoFail)
        return fail == 0;
    const auto count = static_cast<std::uint64_t>(judgements);
    return statistics::clopperPearson(static_cast<std::uint64_t>(fail), count, 1e-3).upper >= 0.999;
}

} // namespace

bool runJudgements(int judgements, const std::string &only, std::uint64_t seed) {
    bool good = true;
    const Recording ours(kPlantedScene, seed);
    fmt::print(
        "Whole judgements of the same scene, {} each (a pass states: within 2 % as a whole, 15 "
        "% in a tile):\n",
        judgements);
    for (const Planted &mistake : plantedMistakes(only)) {
        Recording student(kPlantedScene, seed, mistake.integrator);
        student.plant(mistake.change);
        const Ends ends = judge(student, ours, judgements, seed);
        const bool kept = isKept(mistake.asked, ends.fail, judgements);
        good = good && kept;
        fmt::print("  {:<30} fail {:>3}, pass {:>3}, inconclusive {:>3}; would find {:.2g} %  {}\n",
                   mistake.name, ends.fail, ends.pass, ends.open, 100 * ends.mde,
                   mistake.asked == Asked::Nothing ? "(not asked for)"
                   : kept                          ? "ok"
                                                   : "OFF");
        std::fflush(stdout);
    }
    return good;
}

} // namespace calibration
