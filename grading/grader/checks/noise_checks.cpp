// SPDX-License-Identifier: MIT
//
// What the noise of an image says: whether samples are independent, whether the error is what they
// promise, and by which method they were made.
#include <grader/checks/answer.h>
#include <grader/checks/image_noise.h>
#include <grader/checks/image_scene.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "check_groups.h"
#include "radiance_check.h"

namespace grader {

namespace {

using statistics::MomentSummary;
using statistics::RatioEstimate;

constexpr std::size_t kChannels = 3;
/// Of a ratio of variances.
constexpr double kTolerance = 0.15;

CheckResult judgeIndependence(CheckContext &context) {
    ImageNoise noise;
    constexpr double kLevels[] = {1e-4, 1e-4, 1e-5};
    bool rejected = true;
    for (int stage = 0; stage < 3 && rejected; ++stage) {
        noise = measureNoise(context, stage);
        if (noise.failure)
            return *noise.failure;
        rejected = noise.rejects(kLevels[stage]);
    }
    CheckResult result = makeResult(rejected ? Verdict::Fail : Verdict::Pass, noise.describe());
    result.effect = std::max(noise.bias(), rejected ? noise.excess() : 0);
    result.p = std::min(1.0, 2 * std::min(noise.common.pValue, noise.errorP));
    result.mde = noise.detectable();
    if (rejected)
        result.diagnoses = {{"ems.samples_reused", noise.isReused() ? 1 : kVagueFit}};
    return result;
}

/// A floor below a constant sky: the variance of one sample, in units of (albedo L)^2, names the
/// way in which directions are drawn.
std::string nameSkyMethod(double variance) {
    struct Method {
        double variance;
        const char *name;
    };

    constexpr Method kMethods[] = {{5.0 / 3, "uniform directions on the sphere"},
                                   {1.0 / 3, "uniform directions on the hemisphere"},
                                   {0, "directions by the cosine"}};
    for (const Method &method : kMethods) {
        if (std::abs(variance - method.variance) < 0.05)
            return method.name;
    }
    return "none of the usual ways";
}

/// Right means say nothing of the method; the variance does.
CheckResult judgeMethod(CheckContext &context) {
    SceneRandom random(context.seed("method scenes"));
    const Eigen::Isometry3d pose = random.rigid(1.5);
    const Vector3d albedo = random.color(0.3, 0.8);
    const Vector3d radiance = random.color(0.5, 2);
    const TestMesh floor = parallelogram({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}).transformed(pose);
    RadianceCase lit; // nothing in it is near the light, where single samples would be the variance
    lit.rays = raysOnto(floor, lit.columns, 0.35, random);
    RadianceCase open = lit;
    TestScene lamp;
    lamp.addMesh(floor, albedo);
    lamp.addLight(
        parallelogram({-0.4, 0.2, 1.2}, {0.9, 0.1, 0.1}, {0, -0.6, 0.1}).transformed(pose),
        {0, 0, 0}, {.radiance = radiance, .scale = {}, .texture = {}});
    lit.files = lamp.files();
    TestScene sky;
    sky.addMesh(floor, albedo);
    sky.addEnvironment(radiance);
    open.files = sky.files();
    constexpr int kRepeats = 512;
    const protocol::RequestGroup lampGroup = radianceRequest(lit, kRepeats, context.seed("lamp"));

    const ProbeAnswer student = context.ask(lampGroup);
    if (auto failure = unanswered(student))
        return *failure;
    const ProbeAnswer below = context.ask(radianceRequest(open, kRepeats, context.seed("sky")));
    if (auto failure = unanswered(below))
        return *failure;
    const ProbeAnswer ours = context.askReference(lampGroup);
    if (const auto failure = unanswered(ours))
        return makeResult(Verdict::Infra, "our own program gave no answer: " + failure->message);

    const auto samplesOf = [&](const ProbeAnswer &answer) {
        RadianceSamples samples(lit.places());
        samples.add(answer.responses[0].values, kRepeats);
        return samples;
    };
    const RatioEstimate light = statistics::varianceRatio(
        interleaved(samplesOf(student)), interleaved(samplesOf(ours)), {.channels = kChannels});
    const RadianceSamples skySamples = samplesOf(below);
    double variance = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const double unit =
            albedo[static_cast<Eigen::Index>(c)] * radiance[static_cast<Eigen::Index>(c)];
        for (const MomentSummary &place : skySamples.channel(c))
            variance += place.variance / (unit * unit * 3 * static_cast<double>(open.places()));
    }
    const bool sameLight = std::abs(light.ratio - 1) <= kTolerance + kWide * light.standardError;
    const std::string method = nameSkyMethod(variance);
    const bool usualSky = method.rfind("none", 0) != 0;
    CheckResult result = makeResult(
        sameLight && usualSky ? Verdict::Pass : Verdict::Fail,
        fmt::format("With one area light the variance is {} times that of a point uniform on it; "
                    "below a constant sky it is {:.3f} (albedo L)^2, as by {} (uniform on the "
                    "sphere: 1.667).",
                    describe(light), variance, method));
    result.effect = std::abs(light.ratio - 1);
    result.mde = kTolerance + 2 * kWide * light.standardError;
    return result;
}

} // namespace

std::vector<Check> noiseChecks() {
    std::vector<Check> checks = {
        directEmsCheck("independence",
                       "Samples are independent, and the error is what their noise says.",
                       judgeIndependence, 0.03, 0.3),
        directEmsCheck("method", "The noise is that of one sample of one light.", judgeMethod, 0.03,
                       0.3),
    };
    checks.front().evidence = Evidence::Noise;
    return checks;
}

} // namespace grader
