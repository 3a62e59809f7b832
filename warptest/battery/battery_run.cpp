// SPDX-License-Identifier: MIT
#include "battery_run.h"

#include <statistics/chi_square.h>
#include <statistics/random.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

namespace battery {

namespace {

constexpr int kGridSide = 256;
constexpr std::size_t kHiddenPairs = 4096;
constexpr std::size_t kOwnSamples = std::size_t{1} << 16U;
constexpr double kNormalisationTolerance = 1e-3;
constexpr int kMinStratifiedSide = 64;

/// Thrown between two steps when the user has cancelled.
struct Cancelled {};

/// What the warp or the density did instead of answering.
struct CallFailed {
    std::string message;
    bool isStub = false;
};

template <typename Function, typename Elements>
auto ask(const Function &function, const Elements &elements, std::string_view name) {
    decltype(function(elements)) answers;
    try {
        answers = function(elements);
    } catch (const NotImplemented &error) {
        throw CallFailed{error.what(), true};
    } catch (const std::exception &error) {
        throw CallFailed{error.what()};
    }
    if (answers.size() != elements.size()) {
        throw CallFailed{fmt::format("the {} gave {} answers to {} questions", name, answers.size(),
                                     elements.size())};
    }
    return answers;
}

Status statusOf(bool right) {
    return right ? Status::Pass : Status::Fail;
}

Status statusOf(statistics::Decision decision) {
    return decision == statistics::Decision::Pass   ? Status::Pass
           : decision == statistics::Decision::Fail ? Status::Fail
                                                    : Status::Inconclusive;
}

std::string describeRatio(const catalog::RatioLaw &ratio) {
    std::string text = fmt::format(
        "The density is {} times the right one",
        ratio.constantName.empty() ? fmt::format("{:.6g}", ratio.constant) : ratio.constantName);
    if (ratio.cosinePower > 0) {
        text += ", with a cosine too many";
    } else if (ratio.cosinePower < 0) {
        text += ", and a cosine is missing";
    }
    return text + ".";
}

/// Stratified points cost as much as independent ones: no more of them than were asked for.
int stratifiedSide(std::size_t samples) {
    return std::clamp(static_cast<int>(std::sqrt(static_cast<double>(samples))), kMinStratifiedSide,
                      kStratifiedSide);
}

/// The two lists as one.
RangeResult together(RangeResult a, const RangeResult &b) {
    a.total += b.total;
    a.notFinite += b.notFinite;
    a.offNorm += b.offNorm;
    a.outside += b.outside;
    a.worstDistance = std::max(a.worstDistance, b.worstDistance);
    a.badBeyondContract += b.badBeyondContract;
    return a;
}

} // namespace

BatteryRun::BatteryRun(const Warp &warp, const Density &density, const catalog::WarpEntry &target,
                       const TestOptions &options, int repeat)
    : m_warp(warp),
      m_density(density),
      m_target(target),
      m_options(options),
      m_repeat(repeat),
      m_a(options.parameter != 0.0 && target.hasParameter ? options.parameter
                                                          : target.parameters.front()) {}

BatteryRun::BatteryRun(const Warp &warp, const TabulatedTarget &own, const TestOptions &options,
                       int repeat)
    : BatteryRun(warp, own.density, own.entry, options, repeat) {
    m_own = &own;
}

std::vector<Output> BatteryRun::outputsOf(const std::vector<Input> &inputs) const {
    return ask(m_warp, inputs, "warp");
}

std::vector<float> BatteryRun::densitiesOf(const std::vector<Output> &points) const {
    return ask(m_density, points, "density");
}

std::uint64_t BatteryRun::seed(std::string_view purpose, unsigned stage) const {
    return statistics::deriveSeed(m_options.seed, purpose, stage, static_cast<unsigned>(m_repeat));
}

void BatteryRun::step(double fraction) const {
    if (m_options.progress) {
        m_options.progress((m_repeat + fraction) / m_options.repeats);
    }
    if (m_options.isCancelled && m_options.isCancelled()) {
        throw Cancelled();
    }
}

void BatteryRun::add(TestRow row) {
    const bool worse = row.status == Status::Fail ||
                       (row.status == Status::Inconclusive && m_result.verdict == Status::Pass);
    if (worse) {
        m_result.verdict = row.status;
    }
    m_result.rows.push_back(std::move(row));
}

TestResult BatteryRun::run() {
    m_result.verdict = Status::Pass;
    m_result.parameter = m_a;
    try {
        m_own == nullptr ? runSteps() : runOwnDensity();
        summarise();
    } catch (const Cancelled &) {
        m_result = {};
    } catch (const CallFailed &failure) {
        m_result.verdict = Status::Fail;
        m_result.headline =
            failure.isStub ? "not implemented" : "it threw an exception, or did not answer";
        m_result.error = failure.message;
        m_result.isStub = failure.isStub;
    }
    return std::move(m_result);
}

void BatteryRun::runSteps() {
    judgeRange();
    step(0.1);
    judgeDensity();
    step(0.3);
    judgeNormalisation();
    judgeStratified();
    step(0.5);
    judgeDistribution();
    step(0.9);
    judgeConsistency();
    step(1.0);
}

void BatteryRun::runOwnDensity() {
    judgeRange(); // points of density 0 are wrong, whatever it integrates to
    step(0.1);
    const bool isTarget = judgeTable();
    step(0.3);
    if (!isTarget) {
        return;
    }
    judgeStratified();
    step(0.5);
    judgeDistribution();
    step(1.0);
}

bool BatteryRun::judgeTable() {
    const std::size_t invalid = m_own->notFinite + m_own->negative;
    add({"pdf_valid", "pdf < 0 or NaN", fmt::format("{}", invalid), "0", statusOf(invalid == 0)});
    m_result.importance =
        checkByImportance(*m_own, outputsOf(randomInputs(m_options.samples, seed("importance"))));
    m_result.integral = m_own->integral;
    const bool integrated = m_own->isReliable() && m_result.importance.agrees();
    add({"integration", "∫ pdf by another rule", fmt::format("{:.6f}", m_own->checkIntegral),
         fmt::format("{:.6f}", m_own->integral),
         m_own->isReliable() ? Status::Pass : Status::Inconclusive});
    add({"importance", "∫ pdf as samples see it",
         fmt::format("{:.5f} ± {:.1g}", m_result.importance.mean,
                     m_result.importance.standardError),
         "1", m_result.importance.agrees() ? Status::Pass : Status::Inconclusive});
    if (!integrated) {
        m_result.remarks.emplace_back("The density could not be integrated well enough: a chart "
                                      "that follows its peaks, or its grid, would help.");
        return false;
    }
    add({"normalisation", "∫ pdf", fmt::format("{:.6f}", m_result.integral), "1",
         statusOf(std::fabs(m_result.integral - 1.0) <= kNormalisationTolerance)});
    return true;
}

void BatteryRun::judgeRange() {
    const std::vector<Input> grid = gridInputs(kGridSide);
    const Batch batch =
        hideDuplicates(randomInputs(m_options.samples, seed("range")), kHiddenPairs, seed("pairs"));
    const std::vector<Output> outputs = outputsOf(batch.inputs);
    m_result.range = together(battery::judgeRange(m_target, grid, outputsOf(grid)),
                              battery::judgeRange(m_target, batch.inputs, outputs));
    const RangeResult &range = m_result.range;
    add({"range", "outside the support",
         fmt::format("{} of {}", range.outside + range.offNorm, range.total), "0",
         statusOf(range.badFraction() <= kTolerableBadFraction)});
    m_result.duplicates = judgeDuplicates(batch, outputs);
    add({"repeatable", "other point, same sample",
         fmt::format("{} of {}", m_result.duplicates.differing, m_result.duplicates.pairs), "0",
         statusOf(m_result.duplicates.differing == 0)});
    if (m_result.duplicates.differing > 0) {
        m_result.remarks.emplace_back("A warp must use nothing but its sample: no random numbers "
                                      "of its own, no state.");
    }
    const std::vector<Input> edges = edgeInputs();
    m_result.edges = battery::judgeRange(m_target, edges, outputsOf(edges));
    // one such sample is enough: points that are almost on the boundary are for a remark
    const std::size_t notFinite = range.notFinite + m_result.edges.notFinite;
    add({"finite", "NaN or infinite", fmt::format("{}", notFinite), "0", statusOf(notFinite == 0)});
    if (m_result.edges.bad() > 0) {
        m_result.remarks.push_back(
            fmt::format("At {} of {} edge inputs, such as a sample of exactly 0, the point leaves "
                        "the domain.",
                        m_result.edges.bad(), m_result.edges.total));
    }
}

void BatteryRun::judgeDensity() {
    const DensityQueries queries = densityQueries(m_target, m_a, seed("density"));
    m_result.density = battery::judgeDensity(m_target, m_a, queries, densitiesOf(queries.points));
    const DensityResult &found = m_result.density;
    add({"pdf_inside", "pdf inside", fmt::format("largest error {:.2g}", found.maxRelativeError),
         "rounding", statusOf(found.rightInside())});
    add({"pdf_outside", "pdf outside",
         fmt::format("{} of {} not 0", found.nonZeroOutside, found.outsidePoints), "0",
         statusOf(found.rightOutside())});
    add({"pdf_valid", "pdf < 0 or NaN", fmt::format("{}", found.negative + found.notFinite), "0",
         statusOf(found.negative + found.notFinite == 0)});
    if (found.mistake != nullptr) {
        m_result.remarks.emplace_back(found.mistake->description);
    } else if (found.ratio.found && !found.rightInside()) {
        m_result.remarks.push_back(describeRatio(found.ratio));
    }
    judgeDensityAtSamples();
}

void BatteryRun::judgeDensityAtSamples() {
    DensityQueries queries;
    queries.points = outputsOf(randomInputs(kOwnSamples, seed("own samples")));
    queries.kinds.assign(queries.points.size(), QueryKind::Target);
    const DensityResult found =
        battery::judgeDensity(m_target, m_a, queries, densitiesOf(queries.points));
    // what rounding moves off the unit sphere, or off a rim, is a sample all the same
    add({"pdf_at_samples", "pdf 0 at own samples",
         fmt::format("{} of {}", found.zeroAtTarget, found.targetPoints), "0",
         statusOf(found.zeroAtTarget == 0)});
    if (found.zeroAtTarget > 0 && m_result.density.rightInside()) {
        m_result.remarks.emplace_back("The density is 0 at some points that the warp gives: is the "
                                      "norm compared without a tolerance?");
    }
}

void BatteryRun::judgeNormalisation() {
    const std::vector<float> pdfs = densitiesOf(normalisationPoints(m_target, m_a));
    m_result.integral =
        battery::judgeNormalisation(m_target, m_a, pdfs).value + m_result.density.outsideMass;
    add({"normalisation", "∫ pdf", fmt::format("{:.6f}", m_result.integral), "1",
         statusOf(std::fabs(m_result.integral - 1.0) <= kNormalisationTolerance)});
}

void BatteryRun::judgeStratified() {
    const int side = stratifiedSide(m_options.samples);
    const statistics::LockResult lock =
        statistics::tripleLock([&](const statistics::StageRequest &request) {
            m_result.stratified = battery::judgeStratified(
                m_target, m_a,
                outputsOf(stratifiedInputs(side, seed("stratified", request.index))));
            return asStage(m_result.stratified);
        });
    const StratifiedResult &found = m_result.stratified;
    add({"moments", "smooth moments", fmt::format("{:.2g}", found.maxMoment),
         fmt::format("< {:.2g}", found.threshold), statusOf(lock.decision)});
}

statistics::StageResult BatteryRun::runStage(const statistics::StageRequest &request) {
    const std::size_t count = m_options.samples * static_cast<std::size_t>(request.sampleFactor);
    m_outputs = outputsOf(randomInputs(count, seed("distribution", request.index)));
    m_result.points += count;
    m_result.distribution = battery::judgeDistribution(m_target, m_a, m_outputs);
    if (request.index == 0) {
        m_result.seedPValues = {statistics::chiSquareEqualCells(m_result.distribution.counts,
                                                                static_cast<double>(count))
                                    .pValue};
    }
    step(0.5 + 0.1 * (request.index + 1));
    return asStage(m_result.distribution);
}

void BatteryRun::judgeDistribution() {
    statistics::LockConfig config = distributionLock(m_target, m_a);
    const double level = m_options.significance;
    config.significance = {level, level, 0.1 * level};
    const statistics::LockResult lock = statistics::tripleLock(
        [this](const statistics::StageRequest &request) { return runStage(request); }, config);
    m_result.stages = lock.stages.size();
    const Status found = statusOf(lock.decision);
    const DistributionResult &last = m_result.distribution;
    const HistogramTest &finest = last.tests[0];
    add({"histogram", "χ², 32×32 cells",
         fmt::format("{:.1f}, dof {}", finest.statistic, finest.degreesOfFreedom),
         fmt::format("p = {:.2g}", finest.pValue), found});
    add({"distribution", "density of the points",
         fmt::format("{:.2g} % rms off", 100 * last.rmsError),
         fmt::format("p = {:.2g} > {:.2g}", last.pValue, level), found});
    const double detectable = statistics::rmsErrorDetectable(
        last.tests[1].degreesOfFreedom, static_cast<double>(last.total),
        {.significance = level / static_cast<double>(last.tests.size()),
         .tolerance = last.tests[1].tolerance});
    m_result.power = fmt::format(
        "{} points in {} stage(s). An rms error of {:.2g} % would have been found with probability "
        "0.999; whatever is wrong is below {:.2g} % (99.99 %).",
        m_result.points, m_result.stages, 100 * detectable, 100 * last.rmsBound);
    if (found != Status::Fail) {
        return;
    }
    m_result.mistake = nearestMistake(m_target, m_a, m_outputs);
    if (m_result.mistake.mistake != nullptr) {
        m_result.remarks.push_back(fmt::format("{} ({:.0f} % of the deviation is explained)",
                                               m_result.mistake.mistake->description,
                                               100 * m_result.mistake.explained));
    }
    m_result.remarks.push_back(
        fmt::format("Worst in cell ({}, {}) of 8×8 of the unit square: {:+.0f} % points.",
                    last.worstU, last.worstV, 100 * last.worstRelative));
}

void BatteryRun::judgeConsistency() {
    m_result.consistency = battery::judgeConsistency(m_target, m_a, m_outputs,
                                                     densitiesOf(consistencyPoints(m_target, m_a)));
    const bool agree = m_result.consistency.consistent();
    // a diagnosis: two wrongs may well agree with each other
    m_result.rows.push_back({"consistency", "warp and pdf agree",
                             fmt::format("p = {:.2g}", m_result.consistency.pValue), "> 1e-4",
                             agree ? Status::Pass : Status::Inconclusive});
    if (agree && !m_result.density.rightInside() && m_result.verdict == Status::Fail) {
        m_result.remarks.emplace_back(
            "Warp and density agree with each other, but another density was asked for.");
    }
}

void BatteryRun::summarise() {
    switch (m_result.verdict) {
    case Status::Pass:
        m_result.headline = fmt::format("warp and density {} within {:.2g} %",
                                        m_own == nullptr ? "are right" : "agree and integrate to 1",
                                        100 * m_result.distribution.rmsBound);
        break;
    case Status::Fail: {
        std::string names;
        for (const TestRow &row : m_result.rows) {
            if (row.status == Status::Fail) {
                names += (names.empty() ? "" : ", ") + row.name;
            }
        }
        m_result.headline = "wrong: " + names;
        break;
    }
    default:
        m_result.headline = m_result.points > 0 ? "these points cannot tell"
                                                : "the density could not be integrated";
        break;
    }
}

} // namespace battery
