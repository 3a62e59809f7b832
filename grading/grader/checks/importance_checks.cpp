// SPDX-License-Identifier: MIT
#include <grader/checks/answer.h>
#include <grader/checks/light_choice.h>
#include <grader/checks/radiance_case.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "check_groups.h"

namespace grader {

namespace {

constexpr double kTolerance = 0.08; ///< relative, of a frequency that is proportional to radiance

/// Relative, of a ratio of variances.
constexpr double kVarianceTolerance = 0.1;
constexpr std::size_t kBatches = 16;
constexpr std::size_t kBatchSize = 512;

/// Why there is no choice by importance that could be right or wrong; nothing if there is one.
std::optional<CheckResult> nothingToJudge(const LightChoice &choice) {
    if (choice.failure)
        return choice.failure;
    if (choice.recognised < 0.99)
        return makeResult(Verdict::Missing,
                          "A sample does not come from one light: no light is chosen.");
    if (choice.isUniform())
        return makeResult(Verdict::Missing, "Every light is chosen with the same probability: "
                                            "there is no importance sampling of the lights.");
    return std::nullopt;
}

CheckResult judgeChoice(CheckContext &context) {
    const LightChoice choice = measureChoice(context);
    if (const auto nothing = nothingToJudge(choice))
        return *nothing;
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
        result.diagnoses = {
            {law.reciprocal ? "importance.reciprocal" : "importance.not_proportional",
             law.reciprocal ? 1 : 0.6}};
    } else if (result.verdict == Verdict::Fail) {
        result.message = fmt::format("The lights' frequencies are not proportional to their "
                                     "radiance: they differ by up to {:.2g} %.",
                                     100 * law.error);
        result.diagnoses = {{"importance.not_proportional", 0.6}};
    }
    if (std::find(choice.frequencies.begin(), choice.frequencies.end(), 0.0) !=
        choice.frequencies.end())
        result.diagnoses = {{"importance.light_missing"}};
    return result;
}

/// Lights that are never chosen are missing from the image.
CheckResult judgeEveryLight(CheckContext &context) {
    const LightChoice choice = measureEveryKind(context);
    if (const auto nothing = nothingToJudge(choice))
        return *nothing;
    const auto isMissing = [&](std::size_t light) {
        return choice.frequencies[light] == 0;
    };
    const auto missing = std::count(choice.frequencies.begin(), choice.frequencies.end(), 0.0);
    const bool noMeshes = isMissing(kFirstMesh) && isMissing(kSecondMesh);
    CheckResult result = makeResult(
        missing == 0 ? Verdict::Pass : Verdict::Fail,
        fmt::format("Of a point light, two area lights and an environment {} {} never chosen.",
                    missing == 0 ? "none" : fmt::format("{}", missing),
                    missing > 1 ? "are" : "is"));
    result.effect = static_cast<double>(missing) / kKinds;
    if (noMeshes && missing == 2)
        result.diagnoses = {{"importance.built_too_early", 0.9}, {"importance.light_missing", 0.5}};
    else
        result.diagnoses = {{"importance.light_missing"}};
    return result;
}

CheckResult judgeUnbiased(CheckContext &context) {
    const LightChoice choice = measureChoice(context);
    if (const auto nothing = nothingToJudge(choice))
        return *nothing;
    CheckResult result = judgeRadiance(context, choice.test);
    result.diagnoses = {{"importance.not_divided", 0.6}};
    return result;
}

/// Measured against predicted variance: mean of the logarithm over batches of samples.
struct VarianceRatio {
    double log = 0;
    double error = 0; ///< standard error of `log`
    std::optional<CheckResult> failure;
};

/// \param exact  the prediction, summed over rays and channels
VarianceRatio measureVariance(CheckContext &context, const LightChoice &choice, double exact,
                              const char *purpose) {
    VarianceRatio result;
    const ProbeAnswer answer =
        context.ask(radianceRequest(choice.test, kBatches * kBatchSize, context.seed(purpose)));
    if ((result.failure = unanswered(answer)))
        return result;
    const std::vector<float> &values = answer.responses[0].values;
    statistics::RunningMoments logs;
    for (std::size_t batch = 0; batch < kBatches; ++batch) {
        double variance = 0;
        for (std::size_t ray = 0; ray < choice.test.rays.size(); ++ray) {
            for (std::size_t c = 0; c < 3; ++c) {
                statistics::RunningMoments samples;
                for (std::size_t i = 0; i < kBatchSize; ++i) {
                    const std::size_t sample = (ray * kBatches + batch) * kBatchSize + i;
                    samples.add(static_cast<double>(values[3 * sample + c]));
                }
                variance += samples.summary().variance;
            }
        }
        logs.add(std::log(std::max(variance, 1e-30) / exact));
    }
    const statistics::MomentSummary summary = logs.summary();
    result.log = summary.mean;
    result.error = std::sqrt(summary.variance / summary.count);
    return result;
}

/// Quantile of Student's t with kBatches - 1 degrees of freedom, one-sided 99.9 %.
constexpr double kQuantile = 3.73;

/// The improvement that is asked for: noise of a uniform choice against the measured one, compared
/// with what the measured law promises, and with lights that are alike as a control.
CheckResult judgeImprovement(CheckContext &context) {
    const LightChoice choice = measureChoice(context);
    if (const auto nothing = nothingToJudge(choice))
        return *nothing;
    const ChoiceLaw law = nearestLaw(choice);
    const std::vector<double> &chosen =
        law.error <= kTolerance ? law.probabilities : choice.frequencies;
    if (std::any_of(chosen.begin(), chosen.end(), [](double p) { return !(p > 0); }))
        return makeResult(Verdict::Fail, "A light is never chosen.");
    const std::size_t count = choice.intensities.size();
    const std::vector<double> even(count, 1 / static_cast<double>(count));
    const double uniform = exactVariance(choice, even);
    const double promised = uniform / exactVariance(choice, chosen);
    const VarianceRatio found = measureVariance(context, choice, uniform, "variance");
    if (found.failure)
        return *found.failure;
    const LightChoice equal = equalLights(context.seed("equal scene"));
    const VarianceRatio control =
        measureVariance(context, equal, exactVariance(equal, even), "equal variance");
    if (control.failure)
        return *control.failure;

    const double ratio = std::exp(-found.log);
    CheckResult result = makeResult(
        Verdict::Pass,
        fmt::format(
            "The variance is {:.3f} times less than that of a uniform choice (99.8 %: "
            "{:.3f} to {:.3f}); choosing like this promises {:.3f}. With equal lights it is "
            "{:.3f} times less (99.8 %: {:.3f} to {:.3f}), and must be 1.",
            ratio, ratio * std::exp(-kQuantile * found.error),
            ratio * std::exp(kQuantile * found.error), promised, std::exp(-control.log),
            std::exp(-control.log - kQuantile * control.error),
            std::exp(-control.log + kQuantile * control.error)));
    const auto excess = [](double log, double error) {
        return std::max(0.0, std::abs(log) - kQuantile * error);
    };
    const double off = std::max(excess(found.log + std::log(promised), found.error),
                                excess(control.log, control.error));
    result.effect = std::max(std::abs(found.log + std::log(promised)), std::abs(control.log));
    result.mde = kVarianceTolerance + 2 * kQuantile * std::max(found.error, control.error);
    if (off > kVarianceTolerance) {
        result.verdict = Verdict::Fail;
        result.diagnoses = {{"importance.other_noise", 0.5}};
    } else if (promised > 1.1 && found.log + kQuantile * found.error >= 0) {
        result.verdict = Verdict::Fail;
        result.diagnoses = {{"importance.not_proportional", 0.5}};
    }
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
    if (run == judgeUnbiased) {
        check.evidence = Evidence::Images;
        check.locks = kRadianceLocks;
    }
    check.run = run;
    return check;
}

} // namespace

std::vector<Check> importanceChecks() {
    return {
        row("choice", "direct_ems chooses lights in proportion to their radiance.", judgeChoice),
        row("every_light", "Lights of every kind are chosen.", judgeEveryLight),
        row("unbiased", "The mean is right although lights are not chosen alike.", judgeUnbiased),
        row("improvement", "The noise falls as much as the choice of lights promises.",
            judgeImprovement),
    };
}

} // namespace grader
