// SPDX-License-Identifier: MIT
#include "image_noise.h"

#include <grader/checks/answer.h>
#include <grader/checks/image_scene.h>
#include <statistics/mean_tests.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace grader {

namespace {

using statistics::MomentSummary;
using statistics::RatioEstimate;

constexpr std::size_t kChannels = 3;
constexpr int kReplicates = 4;
constexpr int kOurRepeats = 128;
/// Rms, relative to the image's mean: edges depend on how shadow segments are shortened.
constexpr double kBiasTolerance = 0.03;
/// Of the squared error over what the noise says.
constexpr double kErrorTolerance = 1.5;

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

/// Of the difference of two images, over the places that RatioPlaces weighs.
double meanVariance(const std::vector<MomentSummary> &a, const std::vector<MomentSummary> &b,
                    const statistics::RatioPlaces &places) {
    double variance = 0;
    double weights = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        variance += places.weights[i] * (a[i].variance / a[i].count + b[i].variance / b[i].count);
        weights += places.weights[i];
    }
    return weights > 0 ? variance / weights : 0;
}

} // namespace

double ImageNoise::bias() const {
    return mean > 0 ? std::sqrt(std::max(0.0, common.meanSquare)) / mean : 0;
}

double ImageNoise::excess() const {
    return mean > 0 ? std::sqrt(promised * std::max(0.0, error.ratio - 1)) / mean : 0;
}

double ImageNoise::detectable() const {
    if (!(mean > 0))
        return 0;
    const double inCommon = statistics::detectableDifference(common.standardError);
    const double ratio = statistics::detectableDifference(error.standardError);
    const double square = std::min(inCommon, promised * std::max(kErrorTolerance - 1, ratio));
    return std::max(kBiasTolerance, std::sqrt(square) / mean);
}

bool ImageNoise::rejects(double level) const {
    const bool inCommon = common.pValue <= level / 2 && bias() > kBiasTolerance;
    const bool tooLarge = errorP <= level / 2 &&
                          error.ratio - kWide * error.standardError > kErrorTolerance &&
                          excess() > kBiasTolerance;
    return inCommon || tooLarge;
}

bool ImageNoise::isReused() const {
    const double wide = kWide * between.standardError;
    return between.ratio - wide > 1.5 || between.ratio + wide < 0.5;
}

std::string ImageNoise::describe() const {
    return fmt::format(
        "Images with other random numbers have an error of {:.2g} % in common (rms; {:.2g} % would "
        "be found). Means of {} runs vary {} times as their samples say, the squared error is {} "
        "times what they promise (p = {:.2g}); from {} to {} samples the error falls with the "
        "slope {}.",
        100 * bias(), 100 * detectable(), kReplicates, grader::describe(between),
        grader::describe(error), errorP, kNoiseRepeats, kReplicates * kNoiseRepeats,
        describeSlope(decline));
}

ImageNoise measureNoise(CheckContext &context, int stage) {
    ImageNoise noise;
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
            to.push_back(interleaved(samples));
            sum.merge(samples);
        }
    };
    for (int process = 0; process < kReplicates / 2; ++process) {
        const ProbeAnswer student = ask("replicate", process, kNoiseRepeats, false);
        if ((noise.failure = unanswered(student)))
            return noise;
        add(student, kNoiseRepeats, all, images);
        const ProbeAnswer ours = ask("reference", process, kOurRepeats, true);
        if (const auto failure = unanswered(ours)) {
            noise.failure =
                makeResult(Verdict::Infra, "our own program gave no answer: " + failure->message);
            return noise;
        }
        RadianceSamples half(all.places());
        add(ours, kOurRepeats, half, references);
        halves[static_cast<std::size_t>(process)] = interleaved(half);
        allOurs.merge(half);
    }
    const std::vector<MomentSummary> expected = interleaved(allOurs);
    for (const MomentSummary &value : expected)
        noise.mean += value.mean / static_cast<double>(expected.size());
    const std::vector<double> weights = statistics::noiseWeights(expected);
    const statistics::RatioPlaces places = {.channels = kChannels, .weights = weights};
    noise.between = statistics::betweenWithinRatio(images, places);
    noise.error = statistics::errorVarianceRatio(interleaved(all), expected, places);
    // Ours of the first process has as many samples; that of the second is the reference.
    noise.errorP = statistics::errorPValue(interleaved(all), halves[0], halves[1], places);
    noise.promised = meanVariance(interleaved(all), expected, places);
    noise.decline = measureDecline(images, interleaved(all), halves, places);
    std::vector<statistics::ImagePair> pairs;
    for (std::size_t i = 0; i < images.size(); i += 2)
        pairs.push_back({images[i], references[i], images[i + 1], references[i + 1]});
    noise.common = statistics::commonError(pairs, places);
    return noise;
}

std::vector<MomentSummary> interleaved(const RadianceSamples &samples) {
    const RadianceMoments channels = momentsOf(samples);
    std::vector<MomentSummary> result;
    for (std::size_t place = 0; place < samples.places(); ++place) {
        for (std::size_t c = 0; c < kChannels; ++c)
            result.push_back(channels[c][place]);
    }
    return result;
}

std::string describe(const RatioEstimate &ratio) {
    return fmt::format("{:.3f} (99.9 %: {:.3f} to {:.3f})", ratio.ratio,
                       ratio.ratio - kWide * ratio.standardError,
                       ratio.ratio + kWide * ratio.standardError);
}

} // namespace grader
