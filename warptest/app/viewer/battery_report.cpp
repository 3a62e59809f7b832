// SPDX-License-Identifier: MIT
#include <battery/consistency.h>
#include <battery/density.h>
#include <battery/distribution.h>
#include <battery/inputs.h>
#include <battery/nearest_mistake.h>
#include <battery/range.h>
#include <battery/stratified.h>

#include <fmt/core.h>

#include <algorithm>
#include <exception>
#include <utility>

#include <viewer/battery_report.h>

namespace viewer {

namespace {

constexpr int kGridSide = 256;
constexpr double kNormalisationTolerance = 1e-3;

/// Thrown between two steps when the user has cancelled.
struct Cancelled {};

class BatteryRun {
public:
    BatteryRun(const Subject &subject, const Settings &settings, const TestControl &control)
        : m_subject(subject),
          m_truth(*subject.truth),
          m_a(settings.parameter),
          m_seed(settings.seed),
          m_control(control) {}

    TestReport run() {
        m_report.verdict = Status::Pass;
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
        summarise();
        return std::move(m_report);
    }

private:
    std::vector<battery::Output> outputsOf(const std::vector<battery::Input> &inputs) const {
        return m_subject.warp(inputs, m_a);
    }

    [[nodiscard]] std::uint64_t seed(std::uint64_t purpose, std::uint64_t index = 0) const {
        return m_seed * 1000 + purpose * 10 + index; // any distinct numbers do: they are hashed
    }

    void step(double fraction) const {
        m_control.progress(fraction);
        if (m_control.isCancelled()) {
            throw Cancelled();
        }
    }

    void add(std::string name, std::string value, std::string expected, Status status) {
        if (status == Status::Fail ||
            (status == Status::Check && m_report.verdict == Status::Pass)) {
            m_report.verdict = status;
        }
        m_report.health.push_back({std::move(name), std::move(value), std::move(expected), status});
    }

    static Status status(bool right) { return right ? Status::Pass : Status::Fail; }

    void judgeRange() {
        const std::vector<battery::Input> grid = battery::gridInputs(kGridSide);
        const battery::RangeResult range = battery::judgeRange(m_truth, grid, outputsOf(grid));
        add("outside the support",
            fmt::format("{} of {}", range.outside + range.offNorm, range.total), "0",
            status(range.badFraction() <= battery::kTolerableBadFraction));
        add("NaN or infinite", fmt::format("{}", range.notFinite), "0",
            status(range.notFinite == 0));
        const std::vector<battery::Input> edges = battery::edgeInputs();
        const battery::RangeResult edge = battery::judgeRange(m_truth, edges, outputsOf(edges));
        if (edge.bad() > 0) {
            m_report.remarks.push_back(
                fmt::format("At {} of {} edge inputs, such as a sample of exactly 0, the point "
                            "leaves the domain.",
                            edge.bad(), edge.total));
        }
    }

    void judgeDensity() {
        const battery::DensityQueries queries = battery::densityQueries(m_truth, m_a, seed(1));
        const battery::DensityResult found =
            battery::judgeDensity(m_truth, m_a, queries, m_subject.density(queries.points, m_a));
        add("pdf inside", fmt::format("largest error {:.2g}", found.maxRelativeError), "rounding",
            status(found.rightInside()));
        add("pdf outside", fmt::format("{} of {} not 0", found.nonZeroOutside, found.outsidePoints),
            "0", status(found.rightOutside()));
        add("pdf < 0 or NaN", fmt::format("{}", found.negative + found.notFinite), "0",
            status(found.negative + found.notFinite == 0));
        m_outsideMass = found.outsideMass;
        if (found.mistake != nullptr) {
            m_report.remarks.emplace_back(found.mistake->description);
        } else if (found.ratio.found && !found.rightInside()) {
            m_report.remarks.push_back(fmt::format(
                "The density is {} times the right one{}.",
                found.ratio.constantName.empty() ? fmt::format("{:.6g}", found.ratio.constant)
                                                 : found.ratio.constantName,
                found.ratio.cosinePower > 0   ? ", with a cosine too many"
                : found.ratio.cosinePower < 0 ? ", and a cosine is missing"
                                              : ""));
        }
    }

    void judgeNormalisation() {
        const std::vector<float> pdfs =
            m_subject.density(battery::normalisationPoints(m_truth, m_a), m_a);
        const double integral =
            battery::judgeNormalisation(m_truth, m_a, pdfs).value + m_outsideMass;
        add("∫ pdf", fmt::format("{:.6f}", integral), "1",
            status(std::abs(integral - 1.0) <= kNormalisationTolerance));
    }

    void judgeStratified() {
        const battery::StratifiedResult found = battery::judgeStratified(
            m_truth, m_a, outputsOf(battery::stratifiedInputs(battery::kStratifiedSide, seed(2))));
        add("smooth moments", fmt::format("{:.2g}", found.maxMoment),
            fmt::format("< {:.2g}", found.threshold), status(!found.exceeds()));
    }

    void judgeDistribution() {
        std::size_t points = 0;
        const statistics::LockResult lock = statistics::tripleLock(
            [&](const statistics::StageRequest &request) {
                const std::vector<battery::Input> inputs = battery::randomInputs(
                    battery::kDistributionSamples * static_cast<std::size_t>(request.sampleFactor),
                    seed(3, request.index));
                points += inputs.size();
                m_outputs = outputsOf(inputs);
                m_distribution = battery::judgeDistribution(m_truth, m_a, m_outputs);
                step(0.5 + 0.1 * (request.index + 1));
                return battery::asStage(m_distribution);
            },
            battery::distributionLock(m_truth, m_a));
        const Status found = lock.decision == statistics::Decision::Pass   ? Status::Pass
                             : lock.decision == statistics::Decision::Fail ? Status::Fail
                                                                           : Status::Check;
        const battery::HistogramTest &finest = m_distribution.tests[0];
        add("χ², 32×32 cells",
            fmt::format("{:.1f}, dof {}", finest.statistic, finest.degreesOfFreedom),
            fmt::format("p = {:.2g}", finest.pValue), found);
        add("density of the points", fmt::format("{:.2g} % rms off", 100 * m_distribution.rmsError),
            fmt::format("p = {:.2g} > 1e-4", m_distribution.pValue), found);
        m_report.power = fmt::format(
            "{} points in {} stage(s). An rms error of {:.2g} % would have been found with "
            "probability 0.999; whatever is wrong is below {:.2g} % (99.99 %).",
            points, lock.stages.size(), 100 * m_distribution.mde, 100 * m_distribution.rmsBound);
        if (found != Status::Fail) {
            return;
        }
        const battery::MistakeMatch match = battery::nearestMistake(m_truth, m_a, m_outputs);
        if (match.mistake != nullptr) {
            m_report.remarks.push_back(fmt::format("{} ({:.0f} % of the deviation is explained)",
                                                   match.mistake->description,
                                                   100 * match.explained));
        }
        m_report.remarks.push_back(fmt::format(
            "Worst in cell ({}, {}) of 8×8 of the unit square: {:+.0f} % points.",
            m_distribution.worstU, m_distribution.worstV, 100 * m_distribution.worstRelative));
    }

    void judgeConsistency() {
        const battery::ConsistencyResult found = battery::judgeConsistency(
            m_truth, m_a, m_outputs,
            m_subject.density(battery::consistencyPoints(m_truth, m_a), m_a));
        // a diagnosis: two wrongs may well agree with each other
        m_report.health.push_back({"warp and pdf agree", fmt::format("p = {:.2g}", found.pValue),
                                   "> 1e-4", found.consistent() ? Status::Pass : Status::Check});
    }

    void summarise() {
        switch (m_report.verdict) {
        case Status::Pass:
            m_report.headline = fmt::format("warp and density are right within {:.2g} %",
                                            100 * m_distribution.rmsBound);
            break;
        case Status::Fail: {
            std::string names;
            for (const HealthRow &row : m_report.health) {
                if (row.status == Status::Fail) {
                    names += (names.empty() ? "" : ", ") + row.name;
                }
            }
            m_report.headline = "wrong: " + names;
            break;
        }
        default:
            m_report.headline = "these points cannot tell";
            break;
        }
    }

    const Subject &m_subject;
    const catalog::WarpEntry &m_truth;
    double m_a;
    std::uint64_t m_seed;
    const TestControl &m_control;
    TestReport m_report;
    double m_outsideMass = 0.0;
    std::vector<battery::Output> m_outputs;
    battery::DistributionResult m_distribution;
};

} // namespace

TestReport runBattery(const Subject &subject, const Settings &settings,
                      const TestControl &control) {
    try {
        return BatteryRun(subject, settings, control).run();
    } catch (const Cancelled &) {
        return {};
    } catch (const std::exception &error) {
        TestReport report;
        report.verdict = Status::Fail;
        report.headline = "it threw an exception";
        report.error = error.what();
        return report;
    }
}

} // namespace viewer
