// SPDX-License-Identifier: MIT
#include <grader/build/base.h>
#include <grader/checks/answer.h>
#include <grader/checks/emitter_diagnosis.h>
#include <grader/checks/emitter_samples.h>
#include <grader/text_file.h>
#include <statistics/chi_square.h>
#include <statistics/triple_lock.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "check_groups.h"

namespace grader {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kUniformPdf = 1 / (4 * kPi);
constexpr double kTolerance = 1e-3;
constexpr int kSamples = 1 << 18; ///< of the first stage; the others take twice as many
constexpr int kZCells = 16;
constexpr int kPhiCells = 16;
constexpr int kNodes = 8; ///< midpoints per side of a cell, for a density that is not uniform
constexpr std::size_t kQueriesPerCell = std::size_t{kNodes} * kNodes;
constexpr double kToleratedRms = 0.01;
constexpr double kToleratedRmsOfMap = 0.05; ///< the midpoint rule misses the edges of a map's cells

TestScene makeScene(bool constant, std::uint64_t seed) {
    SceneRandom random(seed);
    TestScene scene("normals");
    scene.addMesh(parallelogram({-1, -1, -1}, {2, 0, 0}, {0, 2, 0}).transformed(random.rigid(1)),
                  {0.5, 0.5, 0.5});
    if (constant) {
        scene.addEnvironment({1.5, 0.7, 2.3});
    } else {
        scene.addFile(kSkyMapName, skyMap());
        scene.addEnvironment({255, 230, 200}, kSkyMapName);
    }
    return scene;
}

/// Points away from the origin: a direction must not depend on where it is asked from.
std::vector<Vector3d> referencePoints(std::size_t count, std::uint64_t seed) {
    SceneRandom random(seed);
    std::vector<Vector3d> points;
    for (std::size_t i = 0; i < count; ++i)
        points.emplace_back(random.color(-1.5, 1.5) + Vector3d(1, -0.7, 0.4));
    return points;
}

EmitterQuery queryTowards(const Vector3d &ref, const Vector3d &direction) {
    return {ref, ref + direction, Vector3d::UnitZ(), Vector2d::Zero()};
}

template <typename Judge>
CheckResult withSamples(CheckContext &context, bool constant, const Judge &judge) {
    const EmitterAnswer answer =
        askEmitterSamples(context, makeScene(constant, context.seed("scene")), 0,
                          referencePoints(4096, context.seed("points")), context.seed("samples"));
    return answer.failure ? *answer.failure : judge(answer.rows);
}

bool isUniform(const std::vector<EmitterSampleRow> &rows) {
    return std::all_of(rows.begin(), rows.end(), [](const EmitterSampleRow &row) {
        return std::abs(row.pdf / kUniformPdf - 1) <= kTolerance;
    });
}

CheckResult judgeDirections(const std::vector<EmitterSampleRow> &rows) {
    std::size_t wrong = 0;
    for (const EmitterSampleRow &row : rows)
        wrong += std::abs(row.wi.norm() - 1) <= kTolerance ? 0 : 1;
    return judgeRows(wrong, rows.size(), "sampled directions (not of length 1)",
                     {{"environment.wi_not_unit"}});
}

CheckResult judgeValue(const std::vector<EmitterSampleRow> &rows) {
    return judgeSampleValue(rows, "environment.value_wrong");
}

CheckResult judgeEval(CheckContext &context, bool constant) {
    const TestScene scene = makeScene(constant, context.seed("scene"));
    SceneRandom random(context.seed("directions"));
    std::vector<EmitterQuery> queries;
    for (const Vector3d &ref : referencePoints(4096, context.seed("points")))
        queries.push_back(queryTowards(ref, random.direction()));
    const EvalAnswer answer = askEmitterEval(context, scene, 0, queries);
    if (answer.failure)
        return *answer.failure;
    const EvalAnswer expected = askEmitterEval(context, scene, 0, queries, true);
    if (expected.failure)
        return makeResult(Verdict::Infra,
                          "our own program gave no answer: " + expected.failure->message);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const Vector3d &want = expected.rows[i].eval;
        const double error = (answer.rows[i].eval - want).norm();
        // A few directions fall on the other side of a texel's edge.
        wrong += error <= 0.01 * want.norm() ? 0 : 1;
    }
    return judgeRows(wrong <= queries.size() / 100 ? 0 : wrong, queries.size(),
                     "values of EnvironmentEmitter::eval", {{"environment.eval_changed", 0.9}});
}

CheckResult judgeDensity(const std::vector<EmitterSampleRow> &rows) {
    if (isUniform(rows))
        return judgeRows(0, rows.size(), "densities (1 / 4 pi)", {});
    double mean = 0;
    std::size_t wrong = 0;
    bool constant = true;
    for (const EmitterSampleRow &row : rows) {
        mean += row.pdf / kUniformPdf / static_cast<double>(rows.size());
        wrong += std::abs(row.pdf / kUniformPdf - 1) <= kTolerance ? 0 : 1;
        constant = constant && std::abs(row.pdf - rows[0].pdf) <= kTolerance * std::abs(row.pdf);
    }
    const bool positive = std::all_of(rows.begin(), rows.end(), [](const EmitterSampleRow &row) {
        return std::isfinite(row.pdf) && row.pdf > 0;
    });
    if (constant || !positive)
        return judgeRows(wrong, rows.size(), "densities",
                         {{std::abs(mean - 2) <= kTolerance ? "environment.pdf_hemisphere"
                                                            : "environment.pdf_constant",
                           1}});
    CheckResult result = makeResult(
        Verdict::Pass, "The density is not constant: the map is importance-sampled. It is judged "
                       "against the sampled directions (environment.distribution).");
    result.effect = 0;
    return result;
}

/// Probability of each cell of equal solid angle under the emitter's own density; it is asked at
/// midpoints unless it is uniform.
struct CellProbabilities {
    std::vector<double> cells;
    double tolerance = kToleratedRms;
    std::optional<CheckResult> failure;
};

CellProbabilities askProbabilities(CheckContext &context, const TestScene &scene, bool uniform) {
    CellProbabilities result;
    constexpr int kCells = kZCells * kPhiCells;
    if (uniform) {
        result.cells.assign(kCells, 1.0 / kCells);
        return result;
    }
    // Cells by z, then phi; in each a grid of midpoints.
    const auto coordinate = [](int whole, int node, int cells) {
        return (whole + (node + 0.5) / kNodes) / cells;
    };
    std::vector<EmitterQuery> queries;
    for (int cell = 0; cell < kCells; ++cell) {
        for (int node = 0; node < kNodes * kNodes; ++node) {
            const int row = cell / kPhiCells;
            const int nodeRow = node / kNodes;
            const double z = -1 + 2 * coordinate(row, nodeRow, kZCells);
            const double phi = 2 * kPi * coordinate(cell % kPhiCells, node % kNodes, kPhiCells);
            const double r = std::sqrt(1 - z * z);
            queries.push_back(
                queryTowards({0.3, 0.2, 0.1}, {r * std::cos(phi), r * std::sin(phi), z}));
        }
    }
    const EvalAnswer answer = askEmitterEval(context, scene, 0, queries);
    result.failure = answer.failure;
    if (result.failure)
        return result;
    result.tolerance = kToleratedRmsOfMap;
    result.cells.assign(kCells, 0);
    for (std::size_t i = 0; i < answer.rows.size(); ++i)
        result.cells[i / kQueriesPerCell] +=
            answer.rows[i].pdf * 4 * kPi / kCells / kNodes / kNodes;
    return result;
}

/// Tests sampled directions against the cells' probabilities.
statistics::StageResult compareDirections(const std::vector<EmitterSampleRow> &rows,
                                          const CellProbabilities &expected) {
    std::vector<double> counts(expected.cells.size());
    std::vector<double> wanted;
    for (const double p : expected.cells)
        wanted.push_back(p * static_cast<double>(rows.size()));
    for (const EmitterSampleRow &row : rows) {
        const double phi = std::atan2(row.wi.y(), row.wi.x());
        const double u = std::clamp((row.wi.z() + 1) / 2, 0.0, 1 - 1e-9);
        const double v = std::clamp((phi < 0 ? phi + 2 * kPi : phi) / (2 * kPi), 0.0, 1 - 1e-9);
        if (row.wi.allFinite()) {
            const auto line = static_cast<std::size_t>(u * kZCells);
            const auto column = static_cast<std::size_t>(v * kPhiCells);
            counts[line * kPhiCells + column] += 1;
        }
    }
    const statistics::ChiSquareResult test =
        statistics::chiSquareTest(counts, wanted, {.minExpected = 20});
    const auto n = static_cast<double>(rows.size());
    const int df = test.degreesOfFreedom;
    statistics::StageResult found;
    if (df < 1) { // hardly any density: nothing may be sampled, and yet it is
        found.pValue = 0;
        found.effect = found.effectBound = found.z = 1;
        found.deviation.assign(counts.size(), 1);
        return found;
    }
    found.pValue = statistics::toleranceZonePValue(test.statistic, df, n, expected.tolerance);
    found.effect = statistics::rmsErrorEstimate(test.statistic, df, n);
    found.effectBound = statistics::rmsErrorUpperBound(test.statistic, df, n);
    found.mde = statistics::rmsErrorDetectable(df, n, {.tolerance = expected.tolerance});
    found.z = (test.statistic - df) / std::sqrt(2.0 * df);
    for (std::size_t i = 0; i < counts.size(); ++i)
        found.deviation.push_back((counts[i] - wanted[i]) / std::sqrt(std::max(wanted[i], 1.0)));
    return found;
}

CheckResult judgeDistribution(CheckContext &context) {
    const TestScene scene = makeScene(false, context.seed("scene"));
    std::optional<CheckResult> failure;
    bool uniform = true;
    std::vector<EmitterSampleRow> rows;
    const auto stop = [&](const std::optional<CheckResult> &why) {
        failure = why;
        statistics::StageResult stage;
        stage.reliable = false;
        return stage;
    };
    const auto stage = [&](const statistics::StageRequest &request) {
        const int index = static_cast<int>(request.index);
        const auto count = static_cast<std::size_t>(kSamples) * request.sampleFactor;
        const EmitterAnswer answer = askEmitterSamples(
            context, scene, 0, referencePoints(count, context.seed("points", index)),
            context.seed("samples", index));
        if (answer.failure)
            return stop(answer.failure);
        uniform = isUniform(answer.rows);
        const CellProbabilities expected = askProbabilities(context, scene, uniform);
        if (expected.failure)
            return stop(expected.failure);
        rows = answer.rows;
        return compareDirections(rows, expected);
    };
    const statistics::LockResult lock = statistics::tripleLock(
        stage, {.tolerance = kToleratedRms, .passLimit = 0.2, .sampleFactor = {1, 2, 2}});
    if (failure)
        return *failure;
    const statistics::StageResult &last = lock.stages.back();
    CheckResult result = makeResult(
        lock.decision == statistics::Decision::Pass   ? Verdict::Pass
        : lock.decision == statistics::Decision::Fail ? Verdict::Fail
                                                      : Verdict::Inconclusive,
        fmt::format("The density of the directions differs from {} by {:.2g} % rms (below {:.2g} % "
                    "at 99.99 %).",
                    uniform ? "uniform" : "EnvironmentEmitter::pdf", 100 * last.effect,
                    100 * last.effectBound));
    result.effect = last.effect;
    result.mde = last.mde;
    result.floor = lock.stages.front().mde;
    result.p = last.pValue;
    if (result.verdict == Verdict::Fail)
        result.diagnoses = explain(lock, guessDirections(rows, uniform));
    return result;
}

CheckResult judgeForeignRecord(CheckContext &context) {
    const TestScene scene = makeScene(false, context.seed("scene"));
    const EmitterAnswer answer = askEmitterSamples(
        context, scene, 0, referencePoints(1024, context.seed("points")), context.seed("samples"));
    if (answer.failure)
        return *answer.failure;
    std::vector<EmitterQuery> queries;
    for (const EmitterSampleRow &row : answer.rows)
        queries.push_back(queryTowards(row.ref, row.wi));
    const EvalAnswer evals = askEmitterEval(context, scene, 0, queries);
    if (evals.failure)
        return *evals.failure;
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const double want = answer.rows[i].pdf;
        wrong += std::abs(evals.rows[i].pdf - want) <= 0.01 * std::abs(want) ? 0 : 1;
    }
    // A direction on the edge of a map's cell may round into the next one.
    return judgeRows(wrong <= queries.size() / 50 ? 0 : wrong, queries.size(),
                     "densities of records that sample did not fill in",
                     {{"environment.pdf_stored", 0.8}});
}

Check row(const char *name, const char *what, std::function<CheckResult(CheckContext &)> run) {
    Check check;
    check.id = std::string("environment.") + name;
    check.item = "environment_light";
    check.group = "environment";
    check.what = what;
    check.tolerance = 0.001;
    check.gross = 0.2;
    check.run = std::move(run);
    return check;
}

std::function<CheckResult(CheckContext &)>
samples(CheckResult (*judge)(const std::vector<EmitterSampleRow> &), bool constant = false) {
    return [=](CheckContext &context) {
        return withSamples(context, constant, judge);
    };
}

} // namespace

std::string skyMap() {
    return readTextFile(projectFolder() / "scenes/assignment-2/serapis" / kSkyMapName);
}

std::vector<Check> environmentChecks() {
    std::vector<Check> checks = {
        row("direction", "sample gives a unit direction.", samples(judgeDirections)),
        row("distribution", "Directions are uniform on the sphere, or follow pdf.",
            judgeDistribution),
        row("density", "pdf is 1 / 4 pi, or that of an importance-sampled map.",
            samples(judgeDensity)),
        row("value", "sample's value is the radiance, divided by the density or not.",
            samples(judgeValue)),
        row("eval", "eval is the radiance of the map.",
            [](CheckContext &context) { return judgeEval(context, false); }),
        row("foreign_record", "pdf works for records that sample did not fill in.",
            judgeForeignRecord),
        row("constant", "A constant environment works.", samples(judgeValue, true)),
    };
    for (Check &check : checks) {
        if (check.id == "environment.distribution")
            check.evidence = Evidence::Cells;
    }
    return checks;
}

} // namespace grader
