// SPDX-License-Identifier: MIT
#include <grader/checks/answer.h>
#include <grader/checks/mesh_diagnosis.h>
#include <grader/checks/mesh_samples.h>
#include <statistics/chi_square.h>
#include <statistics/triple_lock.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "check_groups.h"

namespace grader {

namespace {

constexpr int kSamples = 1 << 16;
constexpr double kMinExpected = 20; ///< per pooled cell: the cells are unequal
/// Of the first stage that judges a density; the others' answers are twice as large.
constexpr int kDensitySamples = 1 << 19;
constexpr double kToleratedRms = 0.01;
constexpr double kPositionTolerance = 1e-4; ///< of the mesh's size
constexpr double kNormalTolerance = 2e-3;
constexpr double kUvTolerance = 1e-3;

enum class Shape { Parallelogram, Strip, Ball, Block, FlippedNormals };

TestMesh makeShape(Shape shape, std::uint64_t seed) {
    SceneRandom random(seed);
    TestMesh mesh;
    switch (shape) {
    case Shape::Strip:
        mesh = unequalStrip(random);
        break;
    case Shape::Block: // faces in all directions
        mesh = block({0.1, 0.2, -0.1}, {random.uniform(0.6, 0.9), 0.5, 0.7}, 0.4);
        break;
    case Shape::Ball:
        mesh = sphere({0.3, -0.2, 0.1}, random.uniform(0.5, 0.9), 7);
        break;
    default:
        mesh = parallelogram({-0.4, 0.2, 0}, {random.uniform(0.6, 0.9), 0.1, 0},
                             {-0.15, random.uniform(0.4, 0.6), 0});
        break;
    }
    if (shape == Shape::FlippedNormals)
        mesh.normals.assign(mesh.positions.size(), Vector3d(0, 0, -1));
    return mesh.transformed(random.rigid(2));
}

/// Asks for positions on a mesh that is the only one of a scene.
MeshAnswer askSamples(CheckContext &context, const TestMesh &mesh, int count, int stage) {
    TestScene scene("normals");
    scene.addMesh(mesh, {0.5, 0.5, 0.5});
    MeshAnswer answer =
        askMeshSamples(context, scene, 0, mesh, count, context.seed("samples", stage));
    if (answer.failure && answer.failure->verdict == Verdict::Crash &&
        (mesh.normals.empty() || mesh.uvs.empty()))
        answer.failure->diagnoses = {{"mesh.normals_unchecked", 0.6}};
    return answer;
}

/// Judges something of every sample, no randomness in it: the largest error and its tolerance.
CheckResult
judgeEverySample(CheckContext &context, Shape shape, double tolerance, const char *quantity,
                 double (*error)(const TestMesh &, const MeshSample &),
                 MeshGuesses (*guess)(const TestMesh &, const std::vector<MeshSample> &)) {
    const TestMesh mesh = makeShape(shape, context.seed("mesh"));
    const MeshAnswer answer = askSamples(context, mesh, kSamples / 16, 0);
    if (answer.failure)
        return *answer.failure;
    double worst = 0;
    int wrong = 0;
    for (const MeshSample &sample : answer.samples) {
        const double e = error(mesh, sample);
        worst = std::isfinite(e) ? std::max(worst, e) : 1e9;
        wrong += e <= tolerance ? 0 : 1;
    }
    const double part = static_cast<double>(wrong) / static_cast<double>(answer.samples.size());
    CheckResult result =
        makeResult(wrong == 0 ? Verdict::Pass : Verdict::Fail,
                   fmt::format("{} of {} {} are wrong; the largest error is {:.2g}.", wrong,
                               answer.samples.size(), quantity, worst),
                   guess(mesh, answer.samples));
    result.effect = part;
    return result;
}

/// Stage of the triple lock: are the samples uniform over the area?
struct Uniformity {
    statistics::StageResult stage;
    std::vector<double> counts; ///< per cell
    std::optional<CheckResult> failure;
};

Uniformity uniformityStage(CheckContext &context, const TestMesh &mesh,
                           const statistics::StageRequest &request) {
    Uniformity result;
    const int count = kDensitySamples * request.sampleFactor;
    const MeshAnswer answer = askSamples(context, mesh, count, static_cast<int>(request.index));
    if (answer.failure) {
        result.failure = answer.failure;
        result.stage.reliable = false;
        return result;
    }
    const std::vector<double> expected = uniformCells(mesh, count);
    std::vector<double> observed(expected.size());
    for (const MeshSample &sample : answer.samples) {
        if (sample.distance <= kPositionTolerance) // else judged by mesh.position
            observed[cellOf(sample)] += 1;
    }
    const statistics::ChiSquareResult test =
        statistics::chiSquareTest(observed, expected, {.minExpected = kMinExpected});
    statistics::StageResult &stage = result.stage;
    stage.pValue = statistics::toleranceZonePValue(test.statistic, test.degreesOfFreedom, count,
                                                   kToleratedRms);
    stage.effect = statistics::rmsErrorEstimate(test.statistic, test.degreesOfFreedom, count);
    stage.effectBound =
        statistics::rmsErrorUpperBound(test.statistic, test.degreesOfFreedom, count);
    stage.mde =
        statistics::rmsErrorDetectable(test.degreesOfFreedom, count, {.tolerance = kToleratedRms});
    stage.z = (test.statistic - test.degreesOfFreedom) / std::sqrt(2.0 * test.degreesOfFreedom);
    for (std::size_t i = 0; i < observed.size(); ++i)
        stage.deviation.push_back((observed[i] - expected[i]) / std::sqrt(expected[i]));
    result.counts = observed;
    return result;
}

CheckResult judgeUniformity(CheckContext &context, Shape shape) {
    const TestMesh mesh = makeShape(shape, context.seed("mesh"));
    std::optional<CheckResult> failure;
    std::vector<double> counts;
    double asked = 0;
    const statistics::LockResult lock = statistics::tripleLock(
        [&](const statistics::StageRequest &request) {
            Uniformity found = uniformityStage(context, mesh, request);
            failure = found.failure;
            counts = std::move(found.counts);
            asked = double{kDensitySamples} * request.sampleFactor;
            return found.stage;
        },
        {.tolerance = kToleratedRms, .passLimit = 0.2, .sampleFactor = {1, 2, 2}});
    if (failure)
        return *failure;
    const statistics::StageResult &last = lock.stages.back();
    const Verdict verdict = lock.decision == statistics::Decision::Pass   ? Verdict::Pass
                            : lock.decision == statistics::Decision::Fail ? Verdict::Fail
                                                                          : Verdict::Inconclusive;
    CheckResult result = makeResult(
        verdict,
        fmt::format("The density of points over {} triangles differs from uniform by {:.2g} % rms "
                    "(below {:.2g} % at 99.99 %).",
                    mesh.faces.size(), 100 * last.effect, 100 * last.effectBound),
        verdict == Verdict::Fail ? explain(lock, guessCells(mesh, counts, asked)) : MeshGuesses{});
    result.effect = last.effect;
    result.mde = last.mde;
    result.floor = lock.stages.front().mde;
    result.p = last.pValue;
    return result;
}

CheckResult judgeDensity(CheckContext &context, Shape shape) {
    const TestMesh mesh = makeShape(shape, context.seed("mesh"));
    TestScene scene("normals");
    scene.addMesh(mesh, {0.5, 0.5, 0.5});
    protocol::RequestGroup group;
    group.files = scene.files();
    protocol::Request request;
    request.op = protocol::Op::MeshDensity;
    request.text = TestScene::kFileName;
    for (const Vector3d &p : mesh.positions) {
        for (int i = 0; i < 3; ++i)
            request.values.push_back(static_cast<float>(p[i]));
    }
    group.requests.push_back(request);
    const ProbeAnswer answer = context.ask(group);
    if (auto failure = unanswered(answer))
        return *failure;
    const double area = mesh.area();
    double worst = 0;
    double ratio = 1;
    for (const float density : answer.responses[0].values) {
        const double r = static_cast<double>(density) * area;
        const double error = std::isfinite(r) ? std::abs(r - 1) : 1e9;
        if (error > worst) {
            worst = error;
            ratio = r;
        }
    }
    CheckResult result = makeResult(
        worst <= 1e-4 ? Verdict::Pass : Verdict::Fail,
        fmt::format("Mesh::pdf times the area of {:.4f} is {:.5g}; it must be 1.", area, ratio),
        guessMeshDensity(mesh, ratio));
    result.effect = worst;
    return result;
}

double positionError(const TestMesh &, const MeshSample &sample) {
    return sample.distance;
}

double normalError(const TestMesh &mesh, const MeshSample &sample) {
    return (sample.normal - expectedNormal(mesh, sample)).norm();
}

double uvError(const TestMesh &mesh, const MeshSample &sample) {
    return (sample.uv - expectedUv(mesh, sample)).norm();
}

Check row(const char *name, const char *what, std::function<CheckResult(CheckContext &)> run) {
    Check check;
    check.id = std::string("mesh.") + name;
    check.item = "area_light";
    check.group = "mesh";
    check.what = what;
    check.tolerance = 0.001;
    check.gross = 0.2;
    check.run = std::move(run);
    return check;
}

CheckResult positions(CheckContext &context, Shape shape) {
    return judgeEverySample(context, shape, kPositionTolerance, "points", positionError,
                            guessPositions);
}

CheckResult normals(CheckContext &context, Shape shape) {
    return judgeEverySample(context, shape, kNormalTolerance, "normals", normalError, guessNormals);
}

} // namespace

std::vector<Check> meshChecks() {
    std::vector<Check> checks = {
        row("position", "Points lie on the mesh.",
            [](CheckContext &context) { return positions(context, Shape::Parallelogram); }),
        row("uniform", "Points are uniform on a light of two equal triangles.",
            [](CheckContext &context) { return judgeUniformity(context, Shape::Parallelogram); }),
        row("normal", "Without vertex normals, the normal is the face's.",
            [](CheckContext &context) { return normals(context, Shape::Block); }),
        row("vertex_normal", "Vertex normals are used where the mesh has them.",
            [](CheckContext &context) { return normals(context, Shape::FlippedNormals); }),
        row("density", "Mesh::pdf is 1 / area on a light of two equal triangles.",
            [](CheckContext &context) { return judgeDensity(context, Shape::Parallelogram); }),
        row("unequal", "Points are uniform on triangles of unequal areas.",
            [](CheckContext &context) { return judgeUniformity(context, Shape::Strip); }),
        row("unequal_density", "Mesh::pdf is 1 / area on triangles of unequal areas.",
            [](CheckContext &context) { return judgeDensity(context, Shape::Strip); }),
        row("smooth_normal", "Normals are interpolated on a curved mesh.",
            [](CheckContext &context) { return normals(context, Shape::Ball); }),
        row("uv", "Texture coordinates belong to the point.",
            [](CheckContext &context) {
                return judgeEverySample(context, Shape::Ball, kUvTolerance, "texture coordinates",
                                        uvError, guessUvs);
            }),
    };
    for (Check &check : checks) {
        if (check.id == "mesh.uniform" || check.id == "mesh.unequal")
            check.evidence = Evidence::Cells;
    }
    return checks;
}

} // namespace grader
