// SPDX-License-Identifier: MIT
//
// What the noise of an image says: whether samples are independent, whether the error is what they
// promise, where its numbers come from, and by which method they were made.
#include <grader/checks/answer.h>
#include <grader/checks/image_scene.h>
#include <statistics/mean_tests.h>
#include <statistics/replicates.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "check_groups.h"

namespace grader {

namespace {

using statistics::MomentSummary;
using statistics::RatioEstimate;

constexpr std::size_t kChannels = 3;
constexpr int kReplicates = 4;
constexpr int kRepeats = 64;
constexpr int kOurRepeats = 128;
/// Of a ratio of variances.
constexpr double kTolerance = 0.15;
/// Rms, relative to the image's mean: edges depend on how shadow segments are shortened.
constexpr double kBiasTolerance = 0.03;
constexpr double kWide = 3.29; ///< 99.9 %

std::string describe(const RatioEstimate &ratio) {
    return fmt::format("{:.3f} (99.9 %: {:.3f} to {:.3f})", ratio.ratio,
                       ratio.ratio - kWide * ratio.standardError,
                       ratio.ratio + kWide * ratio.standardError);
}

/// The exponent with which the error falls from one image to all together: -1/2 for independent
/// samples, 0 for samples that are used again.
std::string describeSlope(const RatioEstimate &squaredErrors) {
    if (!(squaredErrors.ratio > 0))
        return "cannot be told";
    const double perLog = 0.5 / std::log(double{kReplicates});
    const double wide = kWide * perLog * squaredErrors.standardError / squaredErrors.ratio;
    const double slope = perLog * std::log(squaredErrors.ratio);
    return fmt::format("{:.2f} (99.9 %: {:.2f} to {:.2f})", slope, slope - wide, slope + wide);
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
    RatioEstimate between; ///< variance of replicates' means, over within
    RatioEstimate error;   ///< squared, over the variance that it should be
    RatioEstimate decline; ///< squared error of all images together over that of one
    statistics::CommonError common;
    double mean = 0; ///< of our image
    std::optional<CheckResult> failure;

    /// Rms of what two images of one process have in common, as a part of the image's mean.
    double bias() const {
        return mean > 0 ? std::sqrt(std::max(0.0, common.meanSquare)) / mean : 0;
    }

    bool rejects(double level) const { return common.pValue <= level && bias() > kBiasTolerance; }
};

/// Errors against two independent halves of what should be seen, whose own noise their product does
/// not hold.
RatioEstimate measureDecline(const std::vector<std::vector<MomentSummary>> &images,
                             const std::vector<MomentSummary> &together,
                             const std::array<std::vector<MomentSummary>, 2> &halves,
                             const statistics::RatioPlaces &places) {
    const auto error = [&](const std::vector<MomentSummary> &image, std::size_t i) {
        return (image[i].mean - halves[0][i].mean) * (image[i].mean - halves[1][i].mean);
    };
    std::vector<double> all;
    std::vector<double> single;
    for (std::size_t i = 0; i < together.size(); ++i) {
        all.push_back(error(together, i));
        double sum = 0;
        for (const auto &image : images)
            sum += error(image, i) / static_cast<double>(images.size());
        single.push_back(sum);
    }
    return statistics::ratioOfSums(all, single, places);
}

/// Two processes with two images each: random numbers may be kept in a static variable.
Noise measureNoise(CheckContext &context, int stage) {
    Noise noise;
    const std::vector<protocol::File> files = imageTemplate("box").fill(context.seed("scene"));
    const auto ask = [&](const char *who, int process, int repeats, bool ours) {
        protocol::RequestGroup group = {files, {}};
        for (int i = 2 * process; i < 2 * process + 2; ++i)
            group.requests.push_back(imageRequest("", repeats, context.seed(who, stage, i)));
        return ours ? context.askReference(group) : context.ask(group);
    };
    std::vector<std::vector<MomentSummary>> images;
    std::vector<std::vector<MomentSummary>> references;
    RadianceSamples all(std::size_t{kImageSize} * kImageSize);
    RadianceSamples allOurs(all.places());
    std::array<std::vector<MomentSummary>, 2> halves; ///< of ours
    const auto add = [](const ProbeAnswer &answer, int repeats, RadianceSamples &sum,
                        std::vector<std::vector<MomentSummary>> &to) {
        for (const protocol::Response &response : answer.responses) {
            RadianceSamples samples(sum.places());
            samples.add(response.values, repeats);
            to.push_back(flat(samples));
            sum.merge(samples);
        }
    };
    for (int process = 0; process < kReplicates / 2; ++process) {
        const ProbeAnswer student = ask("replicate", process, kRepeats, false);
        if ((noise.failure = unanswered(student)))
            return noise;
        add(student, kRepeats, all, images);
        const ProbeAnswer ours = ask("reference", process, kOurRepeats, true);
        if (const auto failure = unanswered(ours)) {
            noise.failure =
                makeResult(Verdict::Infra, "our own program gave no answer: " + failure->message);
            return noise;
        }
        RadianceSamples half(all.places());
        add(ours, kOurRepeats, half, references);
        halves[static_cast<std::size_t>(process)] = flat(half);
        allOurs.merge(half);
    }
    const std::vector<MomentSummary> expected = flat(allOurs);
    for (const MomentSummary &value : expected)
        noise.mean += value.mean / static_cast<double>(expected.size());
    const std::vector<double> weights = statistics::noiseWeights(expected);
    const statistics::RatioPlaces places = {.channels = kChannels, .weights = weights};
    noise.between = statistics::betweenWithinRatio(images, places);
    noise.error = statistics::errorVarianceRatio(flat(all), expected, places);
    noise.decline = measureDecline(images, flat(all), halves, places);
    std::vector<statistics::ImagePair> pairs;
    for (std::size_t i = 0; i < images.size(); i += 2)
        pairs.push_back({images[i], references[i], images[i + 1], references[i + 1]});
    noise.common = statistics::commonError(pairs, places);
    return noise;
}

/// Rms bias that is found at a level of 1e-4 with a power of 99.9 %.
double detectableBias(const Noise &noise) {
    const double square = statistics::detectableDifference(noise.common.standardError);
    return noise.mean > 0 ? std::max(kBiasTolerance, std::sqrt(square) / noise.mean) : 0;
}

/// Means that scatter more than their samples, or hardly at all, come from numbers used again; an
/// error that is just there leaves them as they must be.
bool isReused(const Noise &noise) {
    const double wide = kWide * noise.between.standardError;
    return noise.between.ratio - wide > 1.5 || noise.between.ratio + wide < 0.5;
}

CheckResult judgeIndependence(CheckContext &context) {
    Noise noise;
    constexpr double kLevels[] = {1e-4, 1e-4, 1e-5};
    bool rejected = true;
    for (int stage = 0; stage < 3 && rejected; ++stage) {
        noise = measureNoise(context, stage);
        if (noise.failure)
            return *noise.failure;
        rejected = noise.rejects(kLevels[stage]);
    }
    CheckResult result = makeResult(
        rejected ? Verdict::Fail : Verdict::Pass,
        fmt::format(
            "Images with other random numbers have an error of {:.2g} % in common (rms; "
            "{:.2g} % would be found). Means of {} runs vary {} times as their samples say, "
            "the squared error is {} times what they promise; from {} to {} samples it falls with "
            "the slope {}.",
            100 * noise.bias(), 100 * detectableBias(noise), kReplicates, describe(noise.between),
            describe(noise.error), kRepeats, kReplicates * kRepeats, describeSlope(noise.decline)));
    result.effect = noise.bias();
    result.p = noise.common.pValue;
    result.mde = detectableBias(noise);
    if (rejected)
        result.diagnoses = {{"ems.samples_reused", isReused(noise) ? 1 : kVagueFit}};
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
        statistics::varianceRatio(flat(theirImage), flat(ourImage), {.channels = kChannels});

    RadianceSamples skySamples(open.places());
    skySamples.add(below.responses[0].values, kSkyRepeats);
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

/// One image twice in one process with the same numbers of the sampler, compared bit for bit.
CheckResult judgeSampler(CheckContext &context) {
    constexpr int kAgain = 16;
    const std::uint64_t seed = context.seed("image");
    const protocol::RequestGroup group = {
        imageTemplate("box").fill(context.seed("scene")),
        {imageRequest("", kAgain, seed), imageRequest("", kAgain, seed)}};
    const ProbeAnswer answer = context.ask(group);
    if (auto failure = unanswered(answer))
        return *failure;
    const std::vector<float> &first = answer.responses[0].values;
    const std::vector<float> &second = answer.responses[1].values;
    std::size_t other = 0;
    for (std::size_t i = 0; i < first.size(); ++i)
        other += std::bit_cast<std::uint32_t>(first[i]) != std::bit_cast<std::uint32_t>(second[i])
                     ? 1
                     : 0;
    const double part = static_cast<double>(other) / static_cast<double>(first.size());
    CheckResult result = makeResult(other == 0 ? Verdict::Pass : Verdict::Fail,
                                    fmt::format("With the same numbers from the sampler {:.2g} % "
                                                "of the samples come out differently.",
                                                100 * part),
                                    {{"ems.own_random_numbers"}});
    result.effect = part;
    return result;
}

Check row(const char *name, const char *what, CheckResult (*run)(CheckContext &)) {
    Check check;
    check.id = std::string("direct_ems.") + name;
    check.item = "direct_ems";
    check.group = "direct_ems";
    check.what = what;
    check.tolerance = 0.03;
    check.gross = 0.3;
    check.falseAlarm = run == judgeIndependence ? kTripleLockLevel : kNoNumber;
    check.run = run;
    return check;
}

} // namespace

std::vector<Check> noiseChecks() {
    return {
        row("independence", "Samples are independent, and the error is what their noise says.",
            judgeIndependence),
        row("sampler", "All random numbers come from the sampler.", judgeSampler),
        row("method", "The noise is that of one sample of one light.", judgeMethod),
    };
}

} // namespace grader
