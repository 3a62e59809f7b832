// SPDX-License-Identifier: MIT
#include <grader/checks/answer.h>
#include <grader/checks/emitter_diagnosis.h>
#include <grader/checks/emitter_samples.h>
#include <grader/checks/mesh_samples.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "check_groups.h"
#include "thread_check.h"

namespace grader {

namespace {

constexpr int kSamples = 4096;
constexpr double kTolerance = 1e-3;
constexpr double kScale = 2.5; ///< of Light::Scaled

/// One light, alone in a scene, and points in front of and behind it.
struct LightScene {
    TestMesh mesh;
    Vector3d radiance;
    TestScene scene{"normals"};
    std::vector<Vector3d> front;
    std::vector<Vector3d> behind;
};

enum class Light { Plain, VertexNormals, Scaled, Textured, Curved, WithoutUv };

/// Half the cells of the texture are bright; cells are 1/4 by 1/6 in uv.
constexpr char kTexture[] = R"(<texture type="checker" name="radiance">
      <integer name="scalex" value="4"/><integer name="scaley" value="6"/></texture>)";

LightScene makeLight(Light kind, std::uint64_t seed) {
    SceneRandom random(seed);
    LightScene light;
    const Eigen::Isometry3d pose = random.rigid(2);
    light.radiance = random.color(1, 8).cast<float>().cast<double>();
    TestMesh local = kind == Light::Curved
                         ? sphere({0, 0, 0}, 0.45, 6)
                         : parallelogram({-0.4, -0.3, 0}, {random.uniform(0.6, 0.9), 0.1, 0},
                                         {-0.15, random.uniform(0.4, 0.6), 0});
    if (kind == Light::WithoutUv)
        local.uvs.clear();
    if (kind == Light::VertexNormals) {
        // As in the course's table scene: the vertex normals oppose the winding, and they count.
        for (auto &face : local.faces)
            std::swap(face[1], face[2]);
        local.normals.assign(local.positions.size(), Vector3d::UnitZ());
    }
    light.mesh = local.transformed(pose);
    Emission emission{light.radiance, {}, {}};
    if (kind == Light::Scaled)
        emission.scale = kScale;
    if (kind == Light::Textured)
        emission.texture = kTexture;
    light.scene.addLight(light.mesh, {0.5, 0.4, 0.3}, emission);
    for (int i = 0; i < kSamples; ++i) {
        const double x = random.uniform(-1.5, 1.5);
        const double y = random.uniform(-1.5, 1.5);
        const double z = random.uniform(0.7, 2.2);
        light.front.emplace_back((pose * Vector3d(x, y, z)).cast<float>().cast<double>());
        light.behind.emplace_back((pose * Vector3d(x, y, -z)).cast<float>().cast<double>());
    }
    return light;
}

MeshSample placeOf(const TestMesh &mesh, const EmitterSampleRow &row) {
    MeshSample place;
    place.position = row.p;
    locate(mesh, place);
    return place;
}

template <typename Judge>
CheckResult withSamples(CheckContext &context, Light kind, const Judge &judge) {
    const LightScene light = makeLight(kind, context.seed("light"));
    const EmitterAnswer answer =
        askEmitterSamples(context, light.scene, 0, light.front, context.seed("samples"));
    return answer.failure ? *answer.failure : judge(light, answer.rows);
}

/// Radiance that is not what it should be.
struct WrongRadiance {
    Vector3d got;
    Vector3d want; ///< not black
};

/// True if every channel is the right one up to a limit, and the limit is reached.
bool isClamped(const std::vector<WrongRadiance> &rows) {
    double limit = 0;
    double brightest = 0;
    for (const WrongRadiance &row : rows) {
        limit = std::max(limit, row.got.maxCoeff());
        brightest = std::max(brightest, row.want.maxCoeff());
    }
    return brightest > (1 + kTolerance) * limit &&
           std::all_of(rows.begin(), rows.end(), [=](const WrongRadiance &row) {
               return (row.got - row.want.cwiseMin(limit)).norm() <= kTolerance * limit;
           });
}

std::vector<Guess> guessEval(Light kind, const std::vector<WrongRadiance> &rows) {
    if (kind == Light::Textured || kind == Light::WithoutUv)
        return {{"area.texture_uv", 0.7}};
    if (rows.empty())
        return {};
    std::vector<double> ratios;
    ratios.reserve(rows.size());
    for (const WrongRadiance &row : rows)
        ratios.push_back(row.got.sum() / row.want.sum());
    const auto all = [&](double target) {
        return std::all_of(ratios.begin(), ratios.end(), [=](double ratio) {
            return std::abs(ratio - target) <= kTolerance * std::max(target, 1.0);
        });
    };
    if (all(0))
        return {
            {kind == Light::VertexNormals ? "mesh.vertex_normals_ignored" : "area.side_reversed",
             1}};
    if (kind == Light::Scaled && all(1 / kScale))
        return {{"area.scale_ignored"}};
    if (all(std::numbers::pi) || all(1 / std::numbers::pi))
        return {{"area.radiance_pi"}};
    if (isClamped(rows))
        return {{"area.radiance_clamped"}};
    return {{all(ratios.front()) ? "area.radiance_factor" : "area.eval_falls_off", 0.8}};
}

/// eval for places on the light, made by us: seen from the front and from behind.
CheckResult judgeEval(CheckContext &context, Light kind, bool fromBehind) {
    const LightScene light = makeLight(kind, context.seed("light"));
    SceneRandom random(context.seed("places"));
    std::vector<EmitterQuery> queries;
    for (const Vector3d &ref : fromBehind ? light.behind : light.front) {
        const double s = random.uniform();
        const double t = random.uniform();
        const TestMesh &mesh = light.mesh;
        const Vector3d p = mesh.positions[0] + s * (mesh.positions[1] - mesh.positions[0]) +
                           t * (mesh.positions[3] - mesh.positions[0]);
        const Vector3d n = mesh.normals.empty() ? mesh.geometricNormal(0) : mesh.normals[0];
        queries.push_back({ref, p, n, {s, t}});
    }
    const EvalAnswer answer = askEmitterEval(context, light.scene, 0, queries);
    if (answer.failure)
        return *answer.failure;
    EvalAnswer expected;
    if (kind == Light::Textured) {
        expected = askEmitterEval(context, light.scene, 0, queries, true);
        if (expected.failure)
            return makeResult(Verdict::Infra,
                              "our own program gave no answer: " + expected.failure->message);
    } else {
        const double scale = kind == Light::Scaled ? kScale : 1;
        const Vector3d value =
            fromBehind ? Vector3d::Zero().eval() : (scale * light.radiance).eval();
        expected.rows.assign(queries.size(), {value, 0});
    }
    std::size_t wrong = 0;
    std::vector<WrongRadiance> wrongValues;
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const Vector3d &got = answer.rows[i].eval;
        const Vector3d &want = expected.rows[i].eval;
        const bool right =
            got.allFinite() && (got - want).norm() <= kTolerance * std::max(want.norm(), 1e-6);
        wrong += right ? 0 : 1;
        if (!right && want.norm() > 0)
            wrongValues.push_back({got, want});
    }
    return judgeRows(wrong, queries.size(), "values of AreaEmitter::eval",
                     fromBehind ? std::vector<Guess>{{"area.two_sided"}}
                                : guessEval(kind, wrongValues));
}

CheckResult judgeRecord(const LightScene &light, const std::vector<EmitterSampleRow> &rows) {
    std::size_t offMesh = 0;
    std::size_t wrongDirection = 0;
    std::size_t wrongDistance = 0;
    for (const EmitterSampleRow &row : rows) {
        const Vector3d toLight = row.p - row.ref;
        const double distance = toLight.norm();
        offMesh += placeOf(light.mesh, row).distance <= kTolerance ? 0 : 1;
        wrongDirection += (row.wi - toLight / distance).norm() <= kTolerance ? 0 : 1;
        wrongDistance += std::abs(row.dist - distance) <= kTolerance * distance ? 0 : 1;
    }
    if (offMesh > 0)
        return judgeRows(offMesh, rows.size(), "sampled points (not on the light's mesh)",
                         {{"area.record_point"}});
    // Integrators take either; one that is set must be right.
    const bool distanceUnset =
        std::all_of(rows.begin(), rows.end(),
                    [](const EmitterSampleRow &row) { return !std::isfinite(row.dist); });
    if (wrongDirection > 0)
        return judgeRows(wrongDirection, rows.size(), "directions wi", guessDirectionToLight(rows));
    CheckResult result =
        judgeRows(distanceUnset ? 0 : wrongDistance, rows.size(),
                  "points, directions and distances in the record", {{"area.dist_wrong"}});
    if (distanceUnset)
        result.message += " The distance is not set.";
    return result;
}

CheckResult judgeValue(const LightScene &, const std::vector<EmitterSampleRow> &rows) {
    std::size_t dark = 0;
    for (const EmitterSampleRow &row : rows)
        dark += row.value.allFinite() && row.value.isZero() ? 1 : 0;
    if (dark == rows.size())
        return judgeRows(dark, rows.size(), "sampled values (all black)",
                         {{"area.side_reversed", 0.7}});
    return judgeSampleValue(rows, "area.value_wrong");
}

/// pdf in solid angle, turned back into area, is 1 / area for every sample (handout, equation 10).
CheckResult judgeDensity(double (*densityOf)(const EmitterSampleRow &), const LightScene &light,
                         const std::vector<EmitterSampleRow> &rows) {
    std::size_t wrong = 0;
    std::vector<DensityRatio> ratios;
    const double area = light.mesh.area();
    for (const EmitterSampleRow &row : rows) {
        const MeshSample place = placeOf(light.mesh, row);
        const Vector3d toLight = row.p - row.ref;
        const double toSquareRadians = toLight.squaredNorm() / area;
        const auto ratioBy = [&](const Vector3d &normal) {
            return densityOf(row) * std::abs(normal.dot(toLight.normalized())) / toSquareRadians;
        };
        const Vector3d normal = expectedNormal(light.mesh, place);
        const double ratio = ratioBy(normal);
        const double geometric = ratioBy(light.mesh.geometricNormal(place.face));
        // The side that faces away, and grazing angles where the two normals or roundings differ,
        // are judged by no scene.
        const bool judged = -normal.dot(toLight.normalized()) > 0.05;
        const double error = std::min(std::abs(ratio - 1), std::abs(geometric - 1));
        wrong += !judged || error <= 4 * kTolerance ? 0 : 1;
        if (judged)
            ratios.push_back({ratio, -normal.dot(toLight.normalized()), toLight.norm()});
    }
    return judgeRows(wrong, rows.size(), "densities", guessAreaDensity(ratios));
}

CheckResult judgeForeignRecord(CheckContext &context) {
    const LightScene light = makeLight(Light::Plain, context.seed("light"));
    const EmitterAnswer answer =
        askEmitterSamples(context, light.scene, 0, light.front, context.seed("samples"));
    if (answer.failure)
        return *answer.failure;
    std::vector<EmitterQuery> queries;
    for (const EmitterSampleRow &row : answer.rows)
        queries.push_back({row.ref, row.p, light.mesh.geometricNormal(0), row.uv});
    const EvalAnswer evals = askEmitterEval(context, light.scene, 0, queries);
    if (evals.failure)
        return *evals.failure;
    std::vector<EmitterSampleRow> rows = answer.rows;
    for (std::size_t i = 0; i < rows.size(); ++i)
        rows[i].pdf = evals.rows[i].pdf;
    const auto judge = [&](const std::vector<EmitterSampleRow> &judged) {
        return judgeDensity([](const EmitterSampleRow &row) { return row.pdf; }, light, judged);
    };
    CheckResult result = judge(rows);
    if (result.verdict == Verdict::Fail && judge(answer.rows).verdict == Verdict::Pass)
        result.diagnoses = {{"area.pdf_stored"}};
    return result;
}

CheckResult judgeBehind(CheckContext &context) {
    const LightScene light = makeLight(Light::Plain, context.seed("light"));
    const EmitterAnswer answer =
        askEmitterSamples(context, light.scene, 0, light.behind, context.seed("samples"));
    if (answer.failure)
        return *answer.failure;
    std::size_t wrong = 0;
    for (const EmitterSampleRow &row : answer.rows)
        wrong += row.value.allFinite() && row.value.isZero() ? 0 : 1;
    return judgeRows(wrong, answer.rows.size(), "samples from behind the light (not black)",
                     {{"area.behind_not_black", 0.8}});
}

CheckResult judgeSharedState(CheckContext &context) {
    constexpr int kTimes = 32; // so many samples that threads meet
    const LightScene light = makeLight(Light::Plain, context.seed("light"));
    protocol::RequestGroup group =
        emitterSampleRequest(light.scene, 0, light.front, context.seed("samples"));
    std::vector<float> &values = group.requests[0].values;
    const std::vector<float> once = values;
    for (int i = 1; i < kTimes; ++i)
        values.insert(values.end(), once.begin(), once.end());
    group.requests.push_back(group.requests[0]);
    group.requests[1].repeats = kThreads;
    return compareThreads(context, std::move(group), "numbers of samples of the light",
                          "area.shared_state");
}

Check row(const char *name, const char *what, std::function<CheckResult(CheckContext &)> run) {
    Check check;
    check.id = std::string("area.") + name;
    check.item = "area_light";
    check.group = "area";
    check.what = what;
    check.tolerance = 0.001;
    check.gross = 0.2;
    check.run = std::move(run);
    return check;
}

std::function<CheckResult(CheckContext &)> density(Light kind) {
    return [kind](CheckContext &context) {
        return withSamples(context, kind, [](const LightScene &light, const auto &rows) {
            return judgeDensity([](const EmitterSampleRow &row) { return row.pdf; }, light, rows);
        });
    };
}

std::function<CheckResult(CheckContext &)> eval(Light kind, bool fromBehind = false) {
    return [=](CheckContext &context) {
        return judgeEval(context, kind, fromBehind);
    };
}

CheckResult judgeRecordPdf(const LightScene &, const std::vector<EmitterSampleRow> &rows) {
    std::size_t wrong = 0;
    for (const EmitterSampleRow &row : rows)
        wrong +=
            std::abs(row.recordPdf - row.pdf) <= kTolerance * row.pdf && row.emitterSet ? 0 : 1;
    return judgeRows(wrong, rows.size(), "records (pdf or emitter left unset)",
                     {{"area.record_unset"}});
}

} // namespace

std::vector<Check> areaChecks() {
    std::vector<Check> checks = {
        row("eval", "eval is the radiance, seen from the front.", eval(Light::Plain)),
        row("eval_behind", "eval is black, seen from behind.", eval(Light::Plain, true)),
        row("record", "sample gives a point of the light, its direction and distance.",
            [](CheckContext &context) { return withSamples(context, Light::Plain, judgeRecord); }),
        row("value", "sample's value is the radiance, divided by the density or not.",
            [](CheckContext &context) { return withSamples(context, Light::Plain, judgeValue); }),
        row("density", "pdf is the area's density converted to solid angle.",
            density(Light::Plain)),
        row("vertex_normals", "A light's vertex normals decide where its front is.",
            eval(Light::VertexNormals)),
        row("sample_behind", "Points behind the light get no light.", judgeBehind),
        row("foreign_record", "pdf works for records that sample did not fill in.",
            judgeForeignRecord),
        row("curved_density", "pdf is right on a curved light of many triangles.",
            density(Light::Curved)),
        row("textured", "A textured light has the radiance of its texture coordinates.",
            eval(Light::Textured)),
        row("without_uv", "A light without texture coordinates works.", eval(Light::WithoutUv)),
        row("threads", "Threads do not disturb each other.", judgeSharedState),
        row("scale", "The property `scale` multiplies the radiance.", eval(Light::Scaled)),
        row("record_fields", "sample sets the record's pdf and emitter.",
            [](CheckContext &context) {
                return withSamples(context, Light::Plain, judgeRecordPdf);
            }),
    };
    // Integrators may work out the record's fields by themselves, and no scene of the handout has a
    // scale: who depends on them shows it.
    for (Check &check : checks)
        check.excusesNobody = check.id == "area.record_fields" || check.id == "area.scale";
    return checks;
}

} // namespace grader
