// SPDX-License-Identifier: MIT
#include "radiance_case.h"

#include <grader/checks/answer.h>
#include <statistics/tile_welch.h>
#include <statistics/triple_lock.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace grader {

namespace {

using statistics::MomentSummary;

constexpr int kTileSize = 4;
/// Errors that rounding, or a shadow segment shortened in another way, may cause. A statistic
/// counts only where its effect is larger.
constexpr double kGlobalTolerance = 1e-3;
constexpr double kTileTolerance = 1e-2;
/// Samples that the film would drop without a trace; more of them are a visible defect.
constexpr double kInvalidTolerance = 1e-4;
/// For code that is slower than ours by a large factor: a fraction of the samples will do.
constexpr std::array<int, 3> kFewerSamples = {1, 16, 256};
constexpr int kMoreSamples = 4;

struct Radiances {
    std::array<std::vector<MomentSummary>, 3> channels; ///< per ray
    double samples = 0;
    double invalid = 0; ///< not finite or negative: left out, as the film does

    double invalidPart() const { return samples > 0 ? invalid / samples : 0; }
};

Radiances toMoments(const protocol::Response &response, std::size_t rays, int repeats) {
    Radiances result;
    result.samples = static_cast<double>(rays) * repeats;
    for (auto &channel : result.channels)
        channel.resize(rays);
    std::size_t at = 0;
    for (std::size_t ray = 0; ray < rays; ++ray) {
        std::array<statistics::RunningMoments, 3> moments;
        for (int i = 0; i < repeats; ++i, at += 3) {
            const float *value = response.values.data() + at;
            const bool valid = std::all_of(value, value + 3, [](float component) {
                return std::isfinite(component) && component >= 0;
            });
            if (!valid)
                ++result.invalid;
            for (std::size_t c = 0; valid && c < 3; ++c)
                moments[c].add(static_cast<double>(value[c]));
        }
        for (std::size_t c = 0; c < 3; ++c) {
            result.channels[c][ray] = moments[c].summary();
            // A ray without a valid sample shows as black.
            result.channels[c][ray].count = std::max(result.channels[c][ray].count, 2.0);
        }
    }
    return result;
}

/// A closed form has no noise.
Radiances exactMoments(const std::vector<Vector3d> &expected) {
    Radiances result;
    for (std::size_t c = 0; c < 3; ++c) {
        for (const Vector3d &value : expected)
            result.channels[c].push_back({1e12, value[static_cast<Eigen::Index>(c)], 0, 0});
    }
    return result;
}

/// One stage's comparison of all three channels.
struct Comparison {
    statistics::StageResult stage;
    double factor = 1;      ///< student / expected, over all channels
    double factorError = 0; ///< standard error of `factor`
};

/// Rms relative deviation of the tiles, noise taken off.
double rmsTileError(const statistics::TileWelchResult &result) {
    double sum = 0;
    for (const statistics::Tile &tile : result.tiles) {
        const double scale = std::max(tile.reference, 0.05 * result.referenceMean);
        if (scale > 0)
            sum += (tile.test.difference * tile.test.difference -
                    tile.test.standardError * tile.test.standardError) /
                   (scale * scale);
    }
    return std::sqrt(std::max(0.0, sum / static_cast<double>(result.tiles.size())));
}

double worstTileError(const statistics::TileWelchResult &result) {
    const statistics::Tile &tile = result.tiles[result.worstTile];
    const double scale = std::max(tile.reference, 0.05 * result.referenceMean);
    return scale > 0 ? std::abs(tile.test.difference) / scale : 1;
}

Comparison compare(const Radiances &student, const Radiances &expected, int columns) {
    Comparison result;
    statistics::StageResult &stage = result.stage;
    stage.effectBound = 0;
    double studentSum = 0;
    double expectedSum = 0;
    double varianceSum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const int rows = static_cast<int>(student.channels[c].size()) / columns;
        const statistics::MomentImage a{columns, rows, student.channels[c]};
        const statistics::MomentImage b{columns, rows, expected.channels[c]};
        const statistics::TileWelchResult found =
            statistics::tileWelchTest(a, b, {.tileSize = kTileSize});

        const double rms = rmsTileError(found);
        const double worst = worstTileError(found);
        const double global = std::abs(found.globalRelativeError);
        double p = 1;
        if (global > kGlobalTolerance)
            p = std::min(p, 3 * found.global.pValue);
        if (found.gateMet && rms > kTileTolerance)
            p = std::min(p, 3 * found.sumPValue);
        if (found.gateMet && worst > kTileTolerance)
            p = std::min(p, 3 * found.maxPValue);
        stage.pValue = std::min(stage.pValue, 3 * p);
        stage.effect = std::max({stage.effect, global, rms});
        stage.effectBound = std::max(stage.effectBound, found.globalBound);
        stage.mde = std::max(stage.mde, found.globalMde);
        stage.z = std::max(stage.z, std::abs(found.global.z));
        stage.reliable = stage.reliable && found.global.gateMet;
        for (const statistics::Tile &tile : found.tiles) {
            stage.z = std::max(stage.z, std::abs(tile.score));
            stage.deviation.push_back(std::clamp(tile.score, -1e6, 1e6));
        }
        studentSum += found.global.difference + found.referenceMean;
        expectedSum += found.referenceMean;
        varianceSum += found.global.standardError * found.global.standardError;
    }
    if (expectedSum > 0) {
        result.factor = studentSum / expectedSum;
        result.factorError = std::sqrt(varianceSum) / expectedSum;
    }
    return result;
}

/// Factors that a whole image is off by, and what they come from.
std::string nameFactor(double factor, int lightCount) {
    constexpr double kPi = std::numbers::pi;

    struct Named {
        double value;
        const char *mistake;
    };

    const double n = lightCount;
    const Named rows[] = {
        {n, "The probability of choosing the light is counted twice, or its reciprocal is used."},
        {1 / n, "The probability of choosing the light is forgotten: with one light of several "
                "sampled, its contribution has to be divided by that probability."},
        {1 / (n * n), "The probability of choosing the light is multiplied instead of divided by."},
        {kPi, "A factor of pi too much: a diffuse BSDF is albedo / pi."},
        {1 / kPi, "A factor of pi too little: check what the BSDF already divides by."},
        {4 * kPi, "A factor of 4 pi too much: check the density of a uniform direction."},
        {1 / (4 * kPi), "A factor of 4 pi too little: check the density of a uniform direction."},
        {2, "Exactly twice as bright: something is added twice, or a density is twice as small."},
        {0.5, "Exactly half as bright: check the density of the sample."},
    };
    for (const Named &row : rows) {
        if (std::abs(factor / row.value - 1) < 0.01 && std::abs(row.value - 1) > 0.1)
            return row.mistake;
    }
    return factor == 0 ? "Nothing arrives: everything is black." : "";
}

struct Asked {
    ProbeAnswer answer;
    int repeats = 0;
};

/// Asks for all samples, or for as many as the code has time for.
template <typename Ask>
Asked askPatiently(const Ask &ask, const RadianceCase &test, int repeats, std::uint64_t seed) {
    Asked asked;
    for (const int divisor : kFewerSamples) {
        asked.repeats = std::max(4, repeats / divisor);
        asked.answer = ask(radianceRequest(test, asked.repeats, seed));
        if (!std::holds_alternative<BoxTimedOut>(asked.answer.outcome.end))
            break;
    }
    return asked;
}

std::string sentence(const Comparison &found, const RadianceCase &test, int repeats) {
    return fmt::format("Along {} rays of {} samples the radiance is {:.4f} +- {:.4f} times what it "
                       "must be; the tiles differ by {:.2g} % rms.",
                       test.rays.size(), repeats, found.factor, found.factorError,
                       100 * found.stage.effect);
}

} // namespace

protocol::RequestGroup radianceRequest(const RadianceCase &test, int repeats, std::uint64_t seed) {
    protocol::RequestGroup group;
    group.files = test.scene.files();
    protocol::Request request;
    request.op = protocol::Op::Radiance;
    request.text = TestScene::kFileName;
    request.repeats = static_cast<std::uint32_t>(repeats);
    request.seed = seed;
    for (const TestRay &ray : test.rays) {
        for (const Vector3d &v : {ray.origin, ray.direction}) {
            for (int i = 0; i < 3; ++i)
                request.values.push_back(static_cast<float>(v[i]));
        }
    }
    group.requests.push_back(std::move(request));
    return group;
}

std::vector<TestRay> raysOnto(const TestMesh &parallelogram, int columns, double distance,
                              SceneRandom &random) {
    const Vector3d &corner = parallelogram.positions[0];
    const Vector3d a = parallelogram.positions[1] - corner;
    const Vector3d b = parallelogram.positions[3] - corner;
    const Vector3d normal = parallelogram.geometricNormal(0);
    std::vector<TestRay> rays;
    for (int row = 0; row < columns; ++row) {
        for (int column = 0; column < columns; ++column) {
            const double s = 0.05 + 0.9 * (column + random.uniform()) / columns;
            const double t = 0.05 + 0.9 * (row + random.uniform()) / columns;
            const Vector3d target = corner + s * a + t * b;
            const Vector3d tilt = random.direction();
            const Vector3d origin = target + distance * (normal + 0.5 * tilt);
            // As floats: the renderer's ray is then exactly the one we compute with.
            TestRay ray;
            ray.origin = origin.cast<float>().cast<double>();
            ray.direction = (target - ray.origin).normalized().cast<float>().cast<double>();
            rays.push_back(ray);
        }
    }
    return rays;
}

Vector3d hitPoint(const TestRay &ray, const TestMesh &mesh, std::size_t face) {
    const Vector3d normal = mesh.geometricNormal(face);
    const Vector3d &on = mesh.positions[static_cast<std::size_t>(mesh.faces[face][0])];
    return ray.origin + ray.direction * ((on - ray.origin).dot(normal) / ray.direction.dot(normal));
}

CheckResult judgeRadiance(CheckContext &context, const RadianceCase &test) {
    CheckResult early;
    bool ended = false;
    Comparison last;
    int lastRepeats = test.repeats;
    double invalidPart = 0;
    const auto stop = [&](CheckResult result) {
        early = std::move(result);
        ended = true;
        statistics::StageResult unreliable;
        unreliable.reliable = false;
        return unreliable;
    };
    const auto look = [&](const statistics::StageRequest &request, int factor) {
        const int index = static_cast<int>(request.index);
        const auto seed = [&](const char *who) {
            return context.seed(who, index, factor);
        };
        const Asked student =
            askPatiently([&](const auto &group) { return context.ask(group); }, test,
                         test.repeats * request.sampleFactor * factor, seed("student"));
        if (auto result = unanswered(student.answer))
            return stop(std::move(*result));
        Radiances expected = exactMoments(test.expected);
        if (test.expected.empty()) {
            const ProbeAnswer answer =
                context.askReference(radianceRequest(test, student.repeats, seed("reference")));
            if (const auto result = unanswered(answer))
                return stop(makeResult(Verdict::Infra,
                                       "our own program gave no answer: " + result->message));
            expected = toMoments(answer.responses[0], test.rays.size(), student.repeats);
        }
        const Radiances radiances =
            toMoments(student.answer.responses[0], test.rays.size(), student.repeats);
        invalidPart = radiances.invalidPart();
        last = compare(radiances, expected, test.columns);
        lastRepeats = student.repeats;
        return last.stage;
    };
    // Where the samples neither reject nor suffice for a pass, one more look with more of them.
    const auto stage = [&](const statistics::StageRequest &request) {
        const statistics::StageResult first = look(request, 1);
        const bool rejects = first.pValue <= request.significance && first.reliable;
        const bool passes = first.effectBound <= test.passBound && first.reliable;
        return ended || rejects || passes ? first : look(request, kMoreSamples);
    };
    const statistics::LockResult lock = statistics::tripleLock(
        stage,
        {.tolerance = kGlobalTolerance, .passLimit = test.passBound, .sampleFactor = {1, 2, 4}});
    if (ended)
        return early;

    CheckResult result = makeResult(Verdict::Inconclusive, sentence(last, test, lastRepeats));
    result.effect = last.stage.effect;
    result.mde = last.stage.mde;
    result.p = last.stage.pValue;
    if (lock.decision == statistics::Decision::Pass)
        result.verdict = Verdict::Pass;
    if (lock.decision == statistics::Decision::Fail) {
        result.verdict = Verdict::Fail;
        result.diagnosis = nameFactor(last.factor, test.lightCount);
    }
    if (invalidPart > kInvalidTolerance && result.verdict != Verdict::Fail) {
        result.verdict = Verdict::Fail;
        result.effect = invalidPart;
        result.diagnosis = "A division by a density of 0, or the root of a negative number?";
    }
    if (invalidPart > 0)
        result.message += fmt::format(" {:.2g} % of the samples are negative, infinite or not a "
                                      "number.",
                                      100 * invalidPart);
    return result;
}

} // namespace grader
