// SPDX-License-Identifier: MIT
#include <battery/density.h>
#include <battery/distribution.h>
#include <battery/inputs.h>
#include <battery/maps.h>
#include <battery/range.h>
#include <battery/scatter.h>
#include <battery/steps.h>
#include <battery/stratified.h>
#include <grader/checks/answer.h>
#include <grader/checks/warp_diagnosis.h>
#include <grader/checks/warp_samples.h>
#include <statistics/triple_lock.h>

#include <fmt/core.h>

#include <algorithm>

#include "check_groups.h"

namespace grader {

namespace {

using battery::Input;
using battery::Output;
using catalog::WarpEntry;

constexpr int kGridSide = 512;
constexpr std::size_t kHiddenPairs = 4096;
/// Probability that a density gives to what is outside of the domain: tolerances on a norm or a
/// rim.
constexpr double kToleratedOutsideMass = 1e-3;
constexpr int kStratifiedStages = 3; ///< all of them must exceed the threshold

std::string atParameter(const WarpEntry &warp, double parameter) {
    return warp.hasParameter ? fmt::format(" at alpha = {:g}", parameter) : "";
}

/// A fraction in percent with two digits, never as `1e+02`.
std::string percent(double fraction) {
    return fraction < 0.995 ? fmt::format("{:.2g}", 100 * fraction)
                            : fmt::format("{:.0f}", 100 * fraction);
}

/// The result that costs most, so that one bad parameter is enough.
void keepWorse(CheckResult &worst, CheckResult next) {
    const auto badness = [](const CheckResult &result) {
        const double effect = result.effect == result.effect ? result.effect : 1e9;
        return std::pair(result.verdict == Verdict::Pass           ? 0
                         : result.verdict == Verdict::Inconclusive ? 1
                                                                   : 2,
                         effect);
    };
    if (worst.message.empty() || badness(next) > badness(worst))
        worst = std::move(next);
}

CheckResult rangeResult(const WarpEntry &warp, double parameter, const battery::RangeResult &range,
                        const std::vector<Input> &inputs, const std::vector<Output> &outputs) {
    const Input &input = inputs[range.firstBad];
    CheckResult result = makeResult(
        Verdict::Fail,
        fmt::format("{} of {} outputs{} are not in the domain ({} not finite, {} not of length 1, "
                    "{} outside), first for the sample ({}, {}).",
                    range.bad(), range.total, atParameter(warp, parameter), range.notFinite,
                    range.offNorm, range.outside, input.u, input.v),
        guessRange(warp, parameter, range, outputs));
    result.effect = range.badFraction();
    return result;
}

/// Deterministic: domain and repeatability. \return  a failure, or an empty message
CheckResult judgeOutputs(const WarpEntry &warp, double parameter, const battery::Batch &batch,
                         const std::vector<Input> &grid, const WarpAnswer &answer) {
    const battery::DuplicateResult repeats = battery::judgeDuplicates(batch, answer.outputs[0]);
    if (repeats.differing > 0) {
        CheckResult result =
            makeResult(Verdict::Fail,
                       fmt::format("{} of {} samples give another point when they come again{}.",
                                   repeats.differing, repeats.pairs, atParameter(warp, parameter)),
                       {{"warp.own_random_numbers"}});
        result.effect = 1;
        return result;
    }
    const std::pair<const std::vector<Input> *, const std::vector<Output> *> lists[] = {
        {&batch.inputs, &answer.outputs[0]}, {&grid, &answer.outputs[1]}};
    for (const auto &[inputs, outputs] : lists) {
        const battery::RangeResult range = battery::judgeRange(warp, *inputs, *outputs);
        if (range.badFraction() > battery::kTolerableBadFraction)
            return rangeResult(warp, parameter, range, *inputs, *outputs);
    }
    return {};
}

/// Outputs on lines. \return  a failure, or an empty message
CheckResult judgeContinuity(const WarpEntry &warp, double parameter,
                            const std::vector<Output> &outputs) {
    const battery::StepResult steps = battery::judgeSteps(warp, parameter, outputs);
    if (!steps.isStepped())
        return {};
    CheckResult result =
        makeResult(Verdict::Fail,
                   fmt::format("The points lie on about {:.0f} lines of constant {}{}.",
                               1 / steps.gap, steps.coordinate, atParameter(warp, parameter)),
                   {{"warp.rounded"}});
    result.effect = std::min(1.0, 10 * steps.gap);
    return result;
}

/// Inputs such as exactly 0, which an image may never draw.
CheckResult judgeEdgesAt(CheckContext &context, const WarpEntry &warp, double parameter) {
    const std::vector<Input> inputs = battery::edgeInputs();
    const WarpAnswer answer = askWarp(context, warp, parameter, {inputs});
    if (answer.failure)
        return *answer.failure;
    const battery::RangeResult edge = battery::judgeRange(warp, inputs, answer.outputs[0]);
    if (edge.bad() > 0)
        return rangeResult(warp, parameter, edge, inputs, answer.outputs[0]);
    CheckResult result =
        makeResult(Verdict::Pass,
                   fmt::format("None of {} edge samples, such as exactly 0, leaves the domain{}.",
                               edge.total, atParameter(warp, parameter)));
    result.effect = 0;
    return result;
}

/// Stratified inputs: far sharper than independent ones, against a fixed bound.
CheckResult judgeStratified(CheckContext &context, const WarpEntry &warp, double parameter) {
    battery::StratifiedResult last;
    double scatter = 0;
    for (int stage = 0; stage < kStratifiedStages; ++stage) {
        const WarpAnswer answer =
            askWarp(context, warp, parameter,
                    {battery::stratifiedInputs(battery::kStratifiedSide,
                                               context.seed("stratified", stage))});
        if (answer.failure)
            return *answer.failure;
        last = battery::judgeStratified(warp, parameter, answer.outputs[0]);
        if (!last.exceeds())
            break;
        scatter = battery::neighbourDistance(answer.outputs[0], battery::kStratifiedSide);
    }
    if (last.exceeds() && scatter > battery::kScattered) { // however well they are distributed
        CheckResult result = makeResult(
            Verdict::Fail,
            fmt::format("Samples next to each other give points as far apart as any two{}: the "
                        "sample is not warped.",
                        atParameter(warp, parameter)));
        result.effect = 1;
        return result;
    }
    CheckResult result = makeResult(
        last.exceeds() ? Verdict::Fail : Verdict::Pass,
        fmt::format("Smooth deviations from the density are {} {:.2g} %{}.",
                    last.exceeds() ? "as large as" : "below",
                    100 * std::max(last.maxMoment, last.threshold), atParameter(warp, parameter)),
        {{"warp.density_of_points", kVagueFit}});
    result.effect = last.maxMoment;
    result.mde = last.threshold;
    return result;
}

/// \param outputs  set to the independent points of the last stage
CheckResult judgeOutputsAt(CheckContext &context, const WarpEntry &warp, double parameter,
                           std::vector<Output> &outputs) {
    const std::string where = atParameter(warp, parameter);
    const std::vector<Input> grid = battery::gridInputs(kGridSide);
    CheckResult ended;
    battery::DistributionResult last;
    const auto stop = [&](CheckResult result) {
        ended = std::move(result);
        statistics::StageResult stage;
        stage.reliable = false;
        return stage;
    };
    const auto stage = [&](const statistics::StageRequest &request) {
        const int index = static_cast<int>(request.index);
        const battery::Batch batch = battery::hideDuplicates(
            battery::randomInputs(battery::kDistributionSamples * request.sampleFactor,
                                  context.seed("inputs", index)),
            kHiddenPairs, context.seed("pairs", index));
        const WarpAnswer answer = askWarp(context, warp, parameter, {batch.inputs, grid});
        if (answer.failure)
            return stop(*answer.failure);
        outputs = battery::withoutDuplicates(batch, answer.outputs[0]);
        CheckResult wrong = judgeOutputs(warp, parameter, batch, grid, answer);
        if (!wrong.message.empty())
            return stop(std::move(wrong));
        last = battery::judgeDistribution(warp, parameter, outputs);
        return battery::asStage(last);
    };
    const statistics::LockResult lock =
        statistics::tripleLock(stage, battery::distributionLock(warp, parameter));
    if (!ended.message.empty())
        return ended;

    CheckResult result =
        makeResult(Verdict::Inconclusive,
                   fmt::format("The density of the points differs from the true one by {} % rms{}",
                               percent(last.rmsError), where));
    result.effect = last.rmsError;
    result.mde = last.mde;
    result.p = last.pValue;
    if (lock.decision == statistics::Decision::Fail) {
        result.verdict = Verdict::Fail;
        result.message += ".";
        result.diagnoses = explain(lock, guessSamples(warp, parameter, outputs));
        return result;
    }
    result.message += fmt::format(" (below {} % at 99.99 %).", percent(last.rmsBound));
    if (CheckResult stepped = judgeContinuity(warp, parameter, outputs); !stepped.message.empty())
        return stepped;
    CheckResult stratified = judgeStratified(context, warp, parameter);
    if (stratified.verdict != Verdict::Pass)
        return stratified;
    if (lock.decision == statistics::Decision::Pass)
        result.verdict = Verdict::Pass;
    return result;
}

PointMap mapOf(const WarpEntry &warp, double parameter, std::span<const Output> outputs) {
    const std::vector<double> counts =
        battery::countCells(battery::makeDomainMap(warp), outputs, battery::kMapSide);
    return {warp.id, parameter, outputs.size(), {counts.begin(), counts.end()}};
}

/// Points, and where something is wrong or may be, a map of them.
CheckResult judgeSamplesAt(CheckContext &context, const WarpEntry &warp, double parameter) {
    std::vector<Output> outputs;
    CheckResult result = judgeOutputsAt(context, warp, parameter, outputs);
    const bool isOff = result.verdict == Verdict::Fail || result.verdict == Verdict::Inconclusive;
    if (isOff && !outputs.empty())
        result.map = mapOf(
            warp, parameter,
            std::span(outputs).first(std::min(outputs.size(), battery::kDistributionSamples)));
    return result;
}

/// \param outside  judge what is outside the support instead of inside
CheckResult judgeDensityAt(CheckContext &context, const WarpEntry &warp, double parameter,
                           bool outside) {
    const battery::DensityQueries queries =
        battery::densityQueries(warp, parameter, context.seed("points"));
    const DensityAnswer answer = askDensity(context, warp, parameter, {queries.points});
    if (answer.failure)
        return *answer.failure;
    const battery::DensityResult found =
        battery::judgeDensity(warp, parameter, queries, answer.densities[0]);
    const std::string where = atParameter(warp, parameter);
    CheckResult result;
    if (outside) {
        const bool right = found.outsideSize <= kToleratedOutsideMass;
        result = makeResult(
            right ? Verdict::Pass : Verdict::Fail,
            fmt::format("The density is not 0 at {} of {} points outside of the domain{}.",
                        found.nonZeroOutside, found.outsidePoints, where),
            guessDensity(warp, found, true));
        result.effect = std::isfinite(found.outsideSize) ? found.outsideSize : 1;
        return result;
    }
    const bool right = found.rightInside() && found.notFinite == 0 && found.negative == 0;
    result = makeResult(
        right ? Verdict::Pass : Verdict::Fail,
        fmt::format("The density is wrong at {} % of the samples{}; it is {:.4g} times the true "
                    "one (median).",
                    percent(found.wrongMass()), where, found.medianRatio),
        guessDensity(warp, found, false));
    result.effect = std::max(found.wrongMass(), right ? 0.0 : 0.001);
    if (found.notFinite > 0)
        result.message += fmt::format(" It is not finite at {} points.", found.notFinite);
    if (found.negative > 0)
        result.message += fmt::format(" It is negative at {} points.", found.negative);
    return result;
}

template <typename Judge>
std::function<CheckResult(CheckContext &)> atEveryParameter(const WarpEntry &warp, Judge judge) {
    return [&warp, judge](CheckContext &context) {
        CheckResult worst;
        for (const double parameter : warp.parameters) {
            keepWorse(worst, judge(context, warp, parameter));
            if (worst.verdict != Verdict::Pass && worst.verdict != Verdict::Inconclusive &&
                worst.verdict != Verdict::Fail)
                break; // a crash or a stub needs no second parameter
        }
        return worst;
    };
}

} // namespace

std::vector<Check> warpChecks() {
    std::vector<Check> checks;
    for (const WarpEntry &warp : catalog::warpCatalog()) {
        if (warp.rubricId.empty())
            continue;
        const std::string item(warp.rubricId);
        Check row;
        row.item = item;
        row.group = "warp";
        row.tolerance = 0.001;
        row.gross = 0.1;

        row.id = item + ".samples";
        row.function = warp.warpFunction;
        row.what = fmt::format("{} gives points of the right density.", warp.warpFunction);
        row.run = atEveryParameter(warp, judgeSamplesAt);
        row.evidence = Evidence::WarpPoints;
        row.locks = static_cast<int>(warp.parameters.size());
        checks.push_back(row);
        row.evidence = Evidence::Fixed;
        row.locks = 1;
        row.id = item + ".edges";
        row.what = fmt::format("{} stays in its domain for samples of exactly 0 and the like.",
                               warp.warpFunction);
        row.run = atEveryParameter(warp, judgeEdgesAt);
        checks.push_back(row);
        row.id = item + ".density";
        row.function = warp.densityFunction;
        row.what = fmt::format("{} is the right density.", warp.densityFunction);
        row.run =
            atEveryParameter(warp, [](CheckContext &context, const WarpEntry &entry, double a) {
                return judgeDensityAt(context, entry, a, false);
            });
        checks.push_back(row);
        row.id = item + ".outside";
        row.what = fmt::format("{} is 0 outside of the domain.", warp.densityFunction);
        row.run =
            atEveryParameter(warp, [](CheckContext &context, const WarpEntry &entry, double a) {
                return judgeDensityAt(context, entry, a, true);
            });
        checks.push_back(row);
    }
    return checks;
}

} // namespace grader
