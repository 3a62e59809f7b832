// SPDX-License-Identifier: MIT
#include "light_choice.h"

#include <grader/checks/answer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace grader {

namespace {

constexpr int kColumns = 8;
constexpr int kRepeats = 4096;
/// 64 rays: a light that is chosen, and seen, once in a thousand times is missed with a chance of
/// exp(-32).
constexpr int kKindRepeats = 512;
constexpr double kChromaticityTolerance = 0.02;
constexpr double kReciprocalTolerance = 0.2; ///< relative, to be told
constexpr double kUniformTolerance =
    0.03; ///< relative; 262144 samples of 7 lights give 0.5 % noise

/// Colours far apart in chromaticity, brightnesses far apart in size.
const Vector3d kColors[] = {{1.0, 0.2, 0.1}, {0.15, 1.0, 0.2}, {0.1, 0.25, 1.0}, {1.0, 0.9, 0.15},
                            {0.9, 0.1, 1.0}, {0.1, 1.0, 0.9},  {0.9, 0.8, 1.0}};
constexpr double kBrightness[] = {1.0, 6.0, 2.5, 0.7, 4.0, 0.9, 0.5};

struct Weight {
    const char *name;
    double (*of)(const Vector3d &intensity);
};

/// What "emitted radiance" is taken to be: a spectrum has no one size.
const Weight kWeights[] = {
    {"luminance",
     [](const Vector3d &c) {
         return 0.212671 * c.x() + 0.715160 * c.y() + 0.072169 * c.z();
     }},
    {"the mean of the channels",
     [](const Vector3d &c) {
         return c.mean();
     }},
    {"the largest channel",
     [](const Vector3d &c) {
         return c.maxCoeff();
     }},
    {"the norm of the colour",
     [](const Vector3d &c) {
         return c.norm();
     }},
    {"the square of the norm",
     [](const Vector3d &c) {
         return c.squaredNorm();
     }},
    {"the red channel",
     [](const Vector3d &c) {
         return c.x();
     }},
    {"the green channel",
     [](const Vector3d &c) {
         return c.y();
     }},
};

/// Lights in a row above a floor. \param equal  all alike
LightChoice makeChoice(std::uint64_t seed, bool equal) {
    LightChoice choice;
    SceneRandom random(seed);
    const Eigen::Isometry3d pose = random.rigid(1.5);
    const TestMesh floor = parallelogram({-1, -0.8, 0}, {2, 0, 0}, {0, 1.7, 0}).transformed(pose);
    choice.albedo = random.color(0.4, 0.7);
    const Vector3d same = random.color(1, 3).cast<float>().cast<double>();
    RadianceCase &test = choice.test;
    test.columns = kColumns;
    test.rays = raysOnto(floor, kColumns, 0.35, random);
    test.expected.assign(test.rays.size(), Vector3d::Zero());
    test.repeats = 8192;
    test.diagnoses.lightCount = static_cast<int>(std::size(kColors));
    choice.contributions.resize(test.rays.size());
    TestScene scene;
    scene.addMesh(floor, choice.albedo);
    for (std::size_t i = 0; i < std::size(kColors); ++i) {
        const Vector3d local(-1.2 + 0.4 * static_cast<double>(i), random.uniform(-0.7, 0.7), 1.3);
        const Vector3d position = (pose * local).cast<float>().cast<double>();
        const Vector3d own =
            (kColors[i] * kBrightness[i] * random.uniform(0.9, 1.1)).cast<float>().cast<double>();
        choice.intensities.push_back(equal ? same : own);
        scene.addPointLight(position, choice.intensities.back());
        for (std::size_t k = 0; k < test.rays.size(); ++k) {
            const Vector3d toLight = position - hitPoint(test.rays[k], floor);
            const double cosTheta = floor.geometricNormal(0).dot(toLight.normalized());
            choice.contributions[k].emplace_back(
                choice.albedo.cwiseProduct(choice.intensities.back()) *
                (cosTheta / std::numbers::pi / toLight.squaredNorm()));
            test.expected[k] += choice.contributions[k].back();
        }
    }
    test.files = scene.files();
    return choice;
}

/// One light of every kind that emits, two of meshes, none hidden: no law leaves one out.
LightChoice makeEveryKind(std::uint64_t seed) {
    LightChoice choice;
    SceneRandom random(seed);
    const Eigen::Isometry3d pose = random.rigid(1.5);
    const TestMesh floor = parallelogram({-1, -0.8, 0}, {2, 0, 0}, {0, 1.7, 0}).transformed(pose);
    choice.albedo = random.color(0.4, 0.7);
    choice.test.columns = kColumns;
    choice.test.rays = raysOnto(floor, kColumns, 0.35, random);
    for (std::size_t i = 0; i < kKinds; ++i)
        choice.intensities.emplace_back(
            (kColors[i] * random.uniform(1, 3)).cast<float>().cast<double>());
    TestScene scene;
    scene.addMesh(floor, choice.albedo);
    scene.addPointLight((pose * Vector3d(-0.6, 0.1, 1.3)).cast<float>().cast<double>(),
                        choice.intensities[kPoint]);
    for (const std::size_t i : {kFirstMesh, kSecondMesh})
        scene.addLight(parallelogram({0.8 * static_cast<double>(i) - 1, 0.3, 1.1}, {0.5, 0.1, 0},
                                     {0, -0.6, 0.1})
                           .transformed(pose),
                       {0.5, 0.5, 0.5},
                       {.radiance = choice.intensities[i], .scale = {}, .texture = {}});
    scene.addEnvironment(choice.intensities[kEnvironment]);
    choice.test.files = scene.files();
    return choice;
}

/// Sets the frequencies: a sample of light i is albedo * intensity_i times a number, so its
/// chromaticity is the light's.
void measure(CheckContext &context, int repeats, LightChoice &choice) {
    const ProbeAnswer answer =
        context.ask(radianceRequest(choice.test, repeats, context.seed("choice")));
    choice.failure = unanswered(answer);
    if (choice.failure)
        return;
    std::vector<double> counts(choice.intensities.size());
    double total = 0;
    const std::vector<float> &values = answer.responses[0].values;
    for (std::size_t at = 0; at + 2 < values.size(); at += 3) {
        const Vector3d value =
            Vector3d(values[at], values[at + 1], values[at + 2]).cwiseQuotient(choice.albedo);
        if (value.isZero(0))
            continue;
        ++total;
        if (!value.allFinite() || !(value.norm() > 0))
            continue;
        for (std::size_t i = 0; i < counts.size(); ++i) {
            if ((value.normalized() - choice.intensities[i].normalized()).norm() <=
                kChromaticityTolerance)
                counts[i] += 1;
        }
    }
    double recognised = 0;
    for (const double count : counts)
        recognised += count;
    choice.recognised = total > 0 ? recognised / total : 0;
    for (const double count : counts)
        choice.frequencies.push_back(recognised > 0 ? count / recognised : 0);
}

} // namespace

bool LightChoice::isUniform() const {
    const double even = 1 / static_cast<double>(frequencies.size());
    return std::all_of(frequencies.begin(), frequencies.end(),
                       [&](double f) { return std::abs(f / even - 1) <= kUniformTolerance; });
}

LightChoice measureChoice(CheckContext &context) {
    LightChoice choice = makeChoice(context.seed("scene"), false);
    measure(context, kRepeats, choice);
    return choice;
}

LightChoice measureEveryKind(CheckContext &context) {
    LightChoice choice = makeEveryKind(context.seed("scene"));
    measure(context, kKindRepeats, choice);
    return choice;
}

LightChoice equalLights(std::uint64_t seed) {
    return makeChoice(seed, true);
}

double exactVariance(const LightChoice &choice, const std::vector<double> &probabilities) {
    double variance = 0;
    for (std::size_t k = 0; k < choice.contributions.size(); ++k) {
        for (std::size_t i = 0; i < probabilities.size(); ++i)
            variance += choice.contributions[k][i].squaredNorm() / probabilities[i];
        variance -= choice.test.expected[k].squaredNorm();
    }
    return variance;
}

ChoiceLaw nearestLaw(const LightChoice &choice) {
    ChoiceLaw best;
    best.error = std::numeric_limits<double>::infinity();
    double reciprocalError = best.error;
    for (const Weight &weight : kWeights) {
        double sum = 0;
        double reciprocalSum = 0;
        for (const Vector3d &intensity : choice.intensities) {
            sum += weight.of(intensity);
            reciprocalSum += 1 / weight.of(intensity);
        }
        double error = 0;
        double otherError = 0;
        std::vector<double> probabilities;
        for (std::size_t i = 0; i < choice.intensities.size(); ++i) {
            const double wanted = weight.of(choice.intensities[i]) / sum;
            const double other = 1 / weight.of(choice.intensities[i]) / reciprocalSum;
            probabilities.push_back(wanted);
            error = std::max(error, std::abs(choice.frequencies[i] / wanted - 1));
            otherError = std::max(otherError, std::abs(choice.frequencies[i] / other - 1));
        }
        if (error < best.error)
            best = {weight.name, error, false, false, std::move(probabilities)};
        reciprocalError = std::min(reciprocalError, otherError);
    }
    best.reciprocal = reciprocalError <= kReciprocalTolerance;
    // Correlation of frequency and luminance.
    double covariance = 0;
    const double even = 1 / static_cast<double>(choice.frequencies.size());
    double mean = 0;
    for (const Vector3d &intensity : choice.intensities)
        mean += kWeights[0].of(intensity) * even;
    for (std::size_t i = 0; i < choice.intensities.size(); ++i)
        covariance +=
            (choice.frequencies[i] - even) * (kWeights[0].of(choice.intensities[i]) - mean);
    best.reversed = covariance < 0;
    return best;
}

} // namespace grader
