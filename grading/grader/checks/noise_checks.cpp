// SPDX-License-Identifier: MIT
//
// What the noise of an image says: whether its samples are independent, whether its error is what
// they promise, and by which method they were made.
#include <grader/checks/answer.h>
#include <grader/checks/image_scene.h>
#include <statistics/replicates.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "check_groups.h"

namespace grader {

namespace {

using statistics::MomentSummary;
using statistics::RatioEstimate;

constexpr std::size_t kChannels = 3;
constexpr int kReplicates = 4;
constexpr int kRepeats = 64;
/// Of ratios of variances: what differs from 1 by less is no mistake.
constexpr double kTolerance = 0.15;
/// Two-sided level 1e-6: a ratio is confirmed with fresh samples once more.
constexpr double kDeviations = 4.9;
constexpr double kWide = 3.29; ///< 99.9 %

std::string describe(const RatioEstimate &ratio) {
    return fmt::format("{:.3f} (99.9 %: {:.3f} to {:.3f})", ratio.ratio,
                       ratio.ratio - kWide * ratio.standardError,
                       ratio.ratio + kWide * ratio.standardError);
}

/// The three channels of each place together.
std::vector<MomentSummary> flat(const RadianceSamples &samples) {
    const RadianceMoments channels = momentsOf(samples);
    std::vector<MomentSummary> result;
    for (std::size_t place = 0; place < samples.places(); ++place) {
        for (std::size_t c = 0; c < kChannels; ++c)
            result.push_back(channels[c][place]);
    }
    return result;
}

struct Noise {
    RatioEstimate between; ///< of replicates, over within
    RatioEstimate error;   ///< squared, over the variance that it should be
    std::optional<CheckResult> failure;
};

/// Every replicate in a process of its own: numbers may be kept in a static variable.
Noise measureNoise(CheckContext &context, int stage) {
    Noise noise;
    const std::vector<protocol::File> files = imageTemplate("table").fill(context.seed("scene"));
    std::vector<std::vector<MomentSummary>> replicates;
    RadianceSamples all(std::size_t{kImageSize} * kImageSize);
    for (int i = 0; i < kReplicates; ++i) {
        const ProbeAnswer answer =
            context.ask({files, {imageRequest("", kRepeats, context.seed("replicate", stage, i))}});
        if ((noise.failure = unanswered(answer)))
            return noise;
        RadianceSamples samples(all.places());
        samples.add(answer.responses[0].values, kRepeats);
        replicates.push_back(flat(samples));
        all.merge(samples);
    }
    constexpr int kOurs = 4 * kReplicates * kRepeats;
    const ProbeAnswer ours =
        context.askReference({files, {imageRequest("", kOurs, context.seed("reference", stage))}});
    if (const auto failure = unanswered(ours)) {
        noise.failure =
            makeResult(Verdict::Infra, "our own program gave no answer: " + failure->message);
        return noise;
    }
    RadianceSamples reference(all.places());
    reference.add(ours.responses[0].values, kOurs);
    noise.between = statistics::betweenWithinRatio(replicates, kChannels);
    noise.error = statistics::errorVarianceRatio(flat(all), flat(reference), kChannels);
    return noise;
}

CheckResult judgeIndependence(CheckContext &context) {
    Noise noise;
    // Three stages: accused is who differs in the same direction every time.
    int stages = 0;
    int tooMuch = 0;
    for (; stages < 3; ++stages) {
        noise = measureNoise(context, stages);
        if (noise.failure)
            return *noise.failure;
        const bool more =
            (noise.between.ratio > 1 && noise.between.differsFromOne(kTolerance, kDeviations)) ||
            (noise.error.ratio > 1 && noise.error.differsFromOne(kTolerance, kDeviations));
        if (!more)
            break;
        ++tooMuch;
    }
    CheckResult result = makeResult(
        tooMuch == 3 ? Verdict::Fail : Verdict::Pass,
        fmt::format("The means of {} runs vary {} times as their samples say; the squared error is "
                    "{} times what it should be; both must be 1.",
                    kReplicates, describe(noise.between), describe(noise.error)));
    result.effect = std::max(std::abs(noise.between.ratio - 1), std::abs(noise.error.ratio - 1));
    result.mde = kTolerance + (kDeviations + 3.1) *
                                  std::max(noise.between.standardError, noise.error.standardError);
    if (tooMuch == 3)
        result.diagnosis =
            noise.between.differsFromOne(kTolerance, kDeviations) && noise.between.ratio > 1
                ? "The samples are not independent: are random numbers used again?"
                : "The error is larger than the noise: the image is wrong, or its samples are "
                  "alike.";
    else if (noise.error.ratio < 1 && noise.error.differsFromOne(0.5, kDeviations))
        result.message += " That little noise comes from stratified samples, or from smoothing.";
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
    const std::vector<protocol::File> box = imageTemplate("box").fill(context.seed("scene"));
    const protocol::RequestGroup boxGroup = {box,
                                             {imageRequest("", 4 * kRepeats, context.seed("box"))}};

    SceneRandom random(context.seed("sky scene"));
    const Eigen::Isometry3d pose = random.rigid(1.5);
    const Vector3d albedo = random.color(0.3, 0.8);
    const Vector3d radiance = random.color(0.5, 2);
    const TestMesh floor = parallelogram({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}).transformed(pose);
    TestScene sky;
    sky.addMesh(floor, albedo);
    sky.addEnvironment(radiance);
    RadianceCase open;
    open.files = sky.files();
    open.rays = raysOnto(floor, open.columns, 0.35, random);
    constexpr int kSkyRepeats = 512;

    const ProbeAnswer student = context.ask(boxGroup);
    if (auto failure = unanswered(student))
        return *failure;
    const ProbeAnswer below = context.ask(radianceRequest(open, kSkyRepeats, context.seed("sky")));
    if (auto failure = unanswered(below))
        return *failure;
    const ProbeAnswer ours = context.askReference(boxGroup);
    if (const auto failure = unanswered(ours))
        return makeResult(Verdict::Infra, "our own program gave no answer: " + failure->message);

    RadianceSamples theirImage(std::size_t{kImageSize} * kImageSize);
    theirImage.add(student.responses[0].values, 4 * kRepeats);
    RadianceSamples ourImage(theirImage.places());
    ourImage.add(ours.responses[0].values, 4 * kRepeats);
    const RatioEstimate light =
        statistics::varianceRatio(flat(theirImage), flat(ourImage), kChannels);

    RadianceSamples skySamples(open.places());
    skySamples.add(below.responses[0].values, kSkyRepeats);
    double variance = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const double unit =
            albedo[static_cast<Eigen::Index>(c)] * radiance[static_cast<Eigen::Index>(c)];
        for (const MomentSummary &place : skySamples.channel(c))
            variance += place.variance / (unit * unit * 3 * static_cast<double>(open.places()));
    }
    const bool sameLight = !light.differsFromOne(kTolerance, kDeviations);
    const std::string method = nameSkyMethod(variance);
    const bool usualSky = method.rfind("none", 0) != 0;
    CheckResult result = makeResult(
        sameLight && usualSky ? Verdict::Pass : Verdict::Fail,
        fmt::format("With one area light the variance is {} times that of a point uniform on it; "
                    "below a constant sky it is {:.3f} (albedo L)^2, as by {} (uniform on the "
                    "sphere: 1.667).",
                    describe(light), variance, method));
    result.effect = std::abs(light.ratio - 1);
    result.mde = kTolerance + (kDeviations + 3.1) * light.standardError;
    if (result.verdict == Verdict::Fail)
        result.diagnosis = "The image is made in another way than by one sample of one light; if "
                           "its mean is right, that is no mistake.";
    return result;
}

Check row(const char *name, const char *what, CheckResult (*run)(CheckContext &)) {
    Check check;
    check.id = std::string("direct_ems.") + name;
    check.item = "direct_ems";
    check.group = "direct_ems";
    check.what = what;
    check.tolerance = 0.1;
    check.gross = 1;
    check.run = run;
    return check;
}

} // namespace

std::vector<Check> noiseChecks() {
    return {
        row("independence", "Samples are independent, and the error is what their noise says.",
            judgeIndependence),
        row("method", "The noise is that of one sample of one light.", judgeMethod),
    };
}

} // namespace grader
