// SPDX-License-Identifier: MIT
#include "convergence_study.h"

#include <grader/converge/hand_in_renderer.h>
#include <grader/error.h>
#include <grader/images/comparison.h>

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace grader {

namespace {

namespace fs = std::filesystem;
using protocol::Image;
using statistics::MomentSummary;

constexpr int kReferenceFactor = 4;
const std::string kHandIn = "hand-in ";
constexpr std::size_t kChannels = 3;
constexpr double kLevel = 1e-4; ///< of a slope's interval
/// Renders of one image differ by their noise, with a ratio of 1; those of two scenes by far more.
constexpr double kOtherImage = 4.0;

/// What renders the replicates of one curve.
struct Estimator {
    std::string name; ///< for labels
    std::string key;  ///< tells its images from others' in the manifest
    std::string file; ///< in the names of its images
    std::string extension = ".exr";
};

std::vector<Estimator> estimatorsOf(const ConvergencePlan &plan, const SceneFile &scene) {
    std::vector<Estimator> estimators;
    const auto names =
        plan.integrators.empty() ? std::vector<std::string>{scene.integrator} : plan.integrators;
    estimators.reserve(names.size() + 1);
    for (const std::string &name : names)
        estimators.push_back({name, name, name});
    if (plan.against)
        estimators.push_back(
            {plan.against->name, kHandIn + plan.against->digest, "handed_in", kPlanesExtension});
    return estimators;
}

std::string stemOf(const SceneFile &scene) {
    return fs::path(scene.name).stem().string();
}

std::string referenceName(const SceneFile &scene, char half) {
    return fmt::format("{}/reference_{}.exr", stemOf(scene), half);
}

std::string replicateName(const SceneFile &scene, const Estimator &estimator, int samples,
                          int replicate) {
    return fmt::format("{}/{}_{}_{}{}", stemOf(scene), estimator.file, samples, replicate,
                       estimator.extension);
}

ReferenceImage imageOf(const ConvergencePlan &plan, const SceneFile &scene,
                       const std::string &integrator, int samples, const std::string &file) {
    ReferenceImage image;
    image.file = file;
    image.scene = scene.name;
    image.sceneDigest = scene.digest;
    image.integrator = integrator;
    image.samplesPerPixel = samples;
    image.seed = seedOf(fmt::format("{} {}", plan.seed, file));
    image.width = plan.width;
    image.height =
        static_cast<int>(std::lround(static_cast<double>(plan.width) * scene.height / scene.width));
    image.version = rendererVersion();
    return image;
}

/// All channels of an image, one after another for each pixel: [pixels * channels].
std::vector<MomentSummary> interleaved(const Image &image, const std::string &name) {
    const auto moments = momentsOf(image);
    if (!moments)
        throw GraderError(name + ": has no moments; `nori --moments` writes them");
    std::vector<MomentSummary> all;
    for (std::size_t i = 0; i < moments->front().pixels.size(); ++i) {
        for (const ChannelMoments &channel : *moments)
            all.push_back(channel.pixels[i]);
    }
    return all;
}

double attribute(const Image &image, const char *name) {
    const auto found = image.attributes.find(name);
    return found == image.attributes.end() ? 0.0 : std::strtod(found->second.c_str(), nullptr);
}

class Evaluation {
public:
    Evaluation(const ConvergencePlan &plan, const fs::path &folder, const LoadImage &load)
        : m_plan(plan), m_folder(folder), m_load(load) {}

    std::vector<Convergence> evaluate() {
        std::vector<Convergence> all;
        for (const SceneFile &scene : m_plan.scenes) {
            const auto halves = loadHalves(scene);
            for (const Estimator &estimator : estimatorsOf(m_plan, scene))
                all.push_back(evaluateOne(scene, estimator, halves));
        }
        return all;
    }

private:
    using Halves = std::array<std::vector<MomentSummary>, 2>;

    Halves loadHalves(const SceneFile &scene) const {
        Halves halves;
        for (std::size_t i = 0; i < halves.size(); ++i) {
            const fs::path file = m_plan.references.empty()
                                      ? m_folder / referenceName(scene, i == 0 ? 'a' : 'b')
                                      : m_plan.references[i];
            halves[i] = interleaved(m_load(file), file.string());
        }
        return halves;
    }

    Convergence evaluateOne(const SceneFile &scene, const Estimator &estimator,
                            const Halves &halves) {
        Convergence result;
        result.scene = scene.name;
        result.integrator = estimator.name;
        result.label = fmt::format("{} {}", stemOf(scene), estimator.name);
        std::vector<statistics::ErrorsAt> errors;
        std::vector<std::vector<MomentSummary>> last; ///< replicates with the most samples
        double cpuSeconds = 0.0;
        double rendered = 0.0; ///< samples per pixel of all images
        try {
            for (const int samples : m_plan.samples) {
                statistics::ErrorsAt at{static_cast<double>(samples), {}};
                last.clear();
                for (int k = 0; k < m_plan.replicates; ++k) {
                    const fs::path file = m_folder / replicateName(scene, estimator, samples, k);
                    const Image image = m_load(file);
                    last.push_back(interleaved(image, file.string()));
                    at.errors.push_back(
                        statistics::debiasedError(last.back(), halves[0], halves[1]));
                    cpuSeconds += attribute(image, "cpuSeconds");
                    rendered += samples;
                }
                errors.push_back(std::move(at));
            }
            result.fit = statistics::fitConvergence(
                errors, kLevel, statistics::commonError(halves[0], halves[1], kChannels));
        } catch (const std::invalid_argument &error) {
            throw GraderError(fmt::format("{}: {}", result.label, error.what()));
        }
        result.cpuSeconds = cpuSeconds / rendered;
        if (m_plan.samples.back() >= 2)
            addVariance(last, result);
        return result;
    }

    void addVariance(const std::vector<std::vector<MomentSummary>> &replicates,
                     Convergence &result) {
        result.betweenWithin = statistics::betweenWithinRatio(replicates, {.channels = kChannels});
        // The replicates' mean variance has the least noise; means are not needed.
        std::vector<MomentSummary> pooled = replicates.front();
        for (std::size_t i = 0; i < pooled.size(); ++i) {
            double sum = 0.0;
            for (const auto &replicate : replicates)
                sum += replicate[i].variance;
            pooled[i].variance = sum / static_cast<double>(replicates.size());
            result.variance += pooled[i].variance / static_cast<double>(pooled.size());
        }
        if (result.variance > 0.0 && result.cpuSeconds > 0.0)
            result.efficiency = 1.0 / (result.variance * result.cpuSeconds);
        if (m_first.empty())
            m_first = pooled;
        else if (m_first.size() == pooled.size() &&
                 statistics::errorVarianceRatio(m_first, pooled, {.channels = kChannels}).ratio <
                     kOtherImage)
            result.gain = statistics::varianceRatio(m_first, pooled, {.channels = kChannels});
    }

    const ConvergencePlan &m_plan;
    const fs::path &m_folder;
    const LoadImage &m_load;
    std::vector<MomentSummary> m_first;
};

} // namespace

std::vector<ReferenceImage> imagesOf(const ConvergencePlan &plan) {
    std::vector<ReferenceImage> images;
    for (const SceneFile &scene : plan.scenes) {
        const std::vector<Estimator> estimators = estimatorsOf(plan, scene);
        if (plan.references.empty()) {
            for (const char half : {'a', 'b'})
                images.push_back(imageOf(plan, scene, estimators.front().key,
                                         kReferenceFactor * plan.samples.back(),
                                         referenceName(scene, half)));
        }
        for (const Estimator &estimator : estimators) {
            for (const int samples : plan.samples) {
                for (int k = 0; k < plan.replicates; ++k)
                    images.push_back(imageOf(plan, scene, estimator.key, samples,
                                             replicateName(scene, estimator, samples, k)));
            }
        }
    }
    return images;
}

std::vector<Convergence> evaluate(const ConvergencePlan &plan, const fs::path &folder,
                                  const LoadImage &load) {
    return Evaluation(plan, folder, load).evaluate();
}

} // namespace grader
