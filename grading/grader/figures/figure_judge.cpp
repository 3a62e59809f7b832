// SPDX-License-Identifier: MIT
#include "figure_judge.h"

#include <grader/digest.h>
#include <grader/error.h>
#include <grader/figures/plateau.h>
#include <grader/scenes/scene_bundle.h>
#include <grader/scenes/test_scene.h>
#include <statistics/random.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace grader {

namespace {

/// The second look is for a figure in which no lack of noise would be found in as few as the first.
constexpr int kPatches[] = {48, 192};
/// Times as many, of which those are taken in which the code's own renders show noise: black ones
/// tell nothing.
constexpr int kCandidates = 4;
constexpr int kPilotSamples = 4;
/// A match that would not notice twice the brightness is none.
constexpr double kUsefulMde = 1;
constexpr int kMostSamples = 256; ///< per pixel of a render
/// Without a stated number of samples, and to find out which other scene it is.
constexpr int kFewSamples = 16;
/// Of a picture of the same scene with other brightnesses; others have less.
constexpr double kSamePicture = 0.95;
/// Of what a figure shows instead: more than kSamePicture, as it is one of many candidates.
constexpr double kOtherScene = 0.98;
/// Part of the named scene's distance from 1 that is left: some scenes show the same picture.
constexpr double kClearlyBetter = 0.25;
/// Smoothing takes noise out of pixels and leaves it in the means of patches.
constexpr double kSmoothed = 2; ///< 1: more samples; 4 to 5: a patch that became flat
/// Below it, differences of means are noise; other values make them 5 and more times as large.
constexpr double kOnlyNoise = 2.5;
constexpr double kSimilar = 0.8; ///< correlation of a noisy picture with the one that it shows
constexpr double kKept = 0.4;    ///< of the noise of patches, by smoothing
constexpr std::size_t kClampSpots = 16;

/// Larger patches where samples are few.
int sideFor(int samples) {
    return samples <= 4 ? 16 : samples <= 64 ? 8 : 4;
}

std::uint64_t seedOf(const std::string &text, const char *purpose) {
    return std::stoull(sha256Hex(fmt::format("{}|{}", text, purpose)).substr(0, 16), nullptr, 16);
}

class Judge {
public:
    Judge(const StatedFigure &figure, const FigureCheck &check, const std::string &seed)
        : m_figure(figure), m_check(check), m_seed(seed) {
        const bool isLevels = figure.image.format == "png";
        m_scale = isLevels ? PixelScale::Levels : PixelScale::Linear;
        m_plan.width = figure.image.width;
        m_plan.height = figure.image.height;
        m_samples = figure.samples > 0 ? std::min(figure.samples, kMostSamples) : kFewSamples;
    }

    FigureResult judge() {
        const SceneBundle bundle = bundleOf(m_figure.scene.scene);
        if (!bundle.film)
            return cannotTell("The scene's film is not the Gaussian one.");
        m_plan.film = *bundle.film;
        if (!look(bundle, kPatches[0], m_seed))
            return cannotTell(m_trouble);
        if (m_result.verdict == FigureVerdict::Match && m_lessNoiseMde <= 0 && countsNoise()) {
            const FigureResult first = m_result;
            const bool isLooked = look(bundle, kPatches[1], m_seed + "|again");
            if (!isLooked || m_rendered < m_samples)
                m_result = first;
        }
        if (std::abs(bundle.width * m_plan.height - bundle.height * m_plan.width) > bundle.width)
            m_result.message +=
                fmt::format(" (It has {} x {} pixels, the scene says {} x {}.)", m_plan.width,
                            m_plan.height, bundle.width, bundle.height);
        return m_result;
    }

private:
    using Renders = std::array<PatchImage, 3>;

    /// Sets the result. \return  false if the hand-in's code does not render the scene
    bool look(const SceneBundle &bundle, int patches, const std::string &seed) {
        m_lookSeed = seed;
        std::optional<Renders> renders;
        if (choosePatches(bundle, patches)) {
            addClampSpots();
            renders = render(bundle, m_samples, "");
        }
        if (!renders)
            return false;
        const bool isClamped = lookAtClampSpots(*renders);
        FigureFindings found = examine(*renders);
        if (m_figure.samples > m_rendered) { // of the stated samples, not of the fewer rendered
            const double fewer = static_cast<double>(m_figure.samples) / m_rendered;
            found.noiseRatio *= fewer;
            found.moreNoiseMde *= fewer;
        }
        m_result.error = found.meanError;
        m_result.mde = found.meanMde;
        m_result.noise = found.noiseRatio;
        m_result.p = std::min(1.0, 3 * std::min({found.meanP, found.moreNoiseP, found.lessNoiseP}));
        m_lessNoiseMde = found.lessNoiseMde;
        decide(found, isClamped);
        return true;
    }

    /// Whether its noise is to be that of the samples that it states.
    bool countsNoise() const {
        return m_figure.samples > 0 && m_figure.scene.fit != FigureScenes::Fit::Variant;
    }

    SceneBundle bundleOf(const std::string &scene) const {
        return readSceneBundle(m_check.scenes.file(scene), ImageSize{m_plan.width, m_plan.height});
    }

    FigureResult cannotTell(const std::string &why) {
        m_result.verdict = FigureVerdict::CannotTell;
        m_result.message = why;
        return m_result;
    }

    /// Those that show noise in a render of their own come first; else any.
    bool choosePatches(const SceneBundle &bundle, int count) {
        m_plan.patches = spreadPatches(m_plan.width, m_plan.height, kCandidates * count,
                                       sideFor(m_samples), seedOf(m_lookSeed, "patches"));
        const auto pilot = render(bundle, kPilotSamples, "pilot");
        if (!pilot)
            return false;
        std::vector<std::size_t> order(m_plan.patches.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        statistics::Random random(seedOf(m_lookSeed, "choice"));
        for (std::size_t i = order.size(); i > 1; --i)
            std::swap(order[i - 1], order[random.nextBelow(i)]);
        std::stable_partition(order.begin(), order.end(),
                              [&](std::size_t i) { return (*pilot)[0][i] != (*pilot)[1][i]; });
        order.resize(std::min(order.size(), static_cast<std::size_t>(count)));
        std::vector<Patch> chosen;
        chosen.reserve(order.size());
        for (const std::size_t i : order)
            chosen.push_back(m_plan.patches[i]);
        m_plan.patches = std::move(chosen);
        m_tested = m_plan.patches.size();
        return true;
    }

    void addClampSpots() {
        if (m_scale == PixelScale::Levels)
            return; // a PNG cannot hold more
        m_plateau = findPlateau(m_figure.image);
        statistics::Random random(seedOf(m_lookSeed, "plateau"));
        std::vector<std::size_t> &spots = m_plateau.spots;
        for (std::size_t i = 0; i < std::min(spots.size(), kClampSpots); ++i) {
            std::swap(spots[i], spots[i + random.nextBelow(spots.size() - i)]);
            const std::size_t pixel = spots[i] / 3;
            const auto width = static_cast<std::size_t>(m_plan.width);
            m_plan.patches.push_back(
                {static_cast<int>(pixel % width), static_cast<int>(pixel / width), 1, 1});
        }
    }

    /// \return  nothing if the hand-in's code does not render it: m_trouble says why
    std::optional<Renders> render(const SceneBundle &bundle, int samples,
                                  const std::string &purpose) {
        for (int count = samples;; count = 1) {
            protocol::RequestGroup group{bundle.files, {}};
            for (const char *which : {"A", "B", "C"}) {
                protocol::Request request;
                request.op = protocol::Op::Film;
                request.text = TestScene::kFileName;
                request.seed = seedOf(m_lookSeed + purpose, which);
                request.values =
                    filmPoints(m_plan, count, seedOf(m_lookSeed + purpose + "points", which));
                group.requests.push_back(std::move(request));
            }
            const ProbeAnswer answer = m_check.ask(group);
            if (answer.complete()) {
                m_rendered = count;
                Renders renders;
                for (std::size_t i = 0; i < renders.size(); ++i)
                    renders[i] = develop(m_plan, group.requests[i].values,
                                         answer.responses[i].values, count);
                return renders;
            }
            if (!std::holds_alternative<BoxTimedOut>(answer.outcome.end) || count == 1) {
                m_trouble = troubleOf(answer);
                return std::nullopt;
            }
        }
    }

    static std::string troubleOf(const ProbeAnswer &answer) {
        for (const protocol::Response &response : answer.responses) {
            if (response.state == protocol::State::Threw)
                return "The code that was handed in does not render the scene: " + response.message;
        }
        return "The code that was handed in does not render the scene: " +
               describe(answer.outcome.end);
    }

    FigurePatches patchesOf(const Renders &renders, std::size_t begin, std::size_t end) const {
        const auto part = [&](const PatchImage &image) {
            return PatchImage(image.begin() + static_cast<long>(begin),
                              image.begin() + static_cast<long>(end));
        };
        FigurePatches patches;
        patches.figure = part(cutOut(m_plan, m_figure.image));
        for (std::size_t i = 0; i < renders.size(); ++i)
            patches.own[i] = part(renders[i]);
        patches.scale = m_scale;
        patches.equalSamples = m_rendered == m_figure.samples;
        return patches;
    }

    FigureFindings examine(const Renders &renders) const {
        return examineFigure(patchesOf(renders, 0, m_tested));
    }

    /// Whether the code's own renders are brighter at most of the spots than the largest value.
    bool lookAtClampSpots(const Renders &renders) const {
        constexpr double kBrighter = 1.05;
        std::size_t brighter = 0;
        const std::size_t count = m_plan.patches.size() - m_tested;
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t c = m_plateau.spots[i] % 3;
            double mean = 0;
            for (const PatchImage &render : renders)
                mean += double{render[m_tested + i].front()[c]} / 3;
            brighter += mean > kBrighter * double{m_plateau.value} ? 1 : 0;
        }
        return count > 0 && 2 * brighter > count;
    }

    void decide(const FigureFindings &found, bool isClamped) {
        const bool sameMeans = found.meanP > kFigureLevel;
        const auto set = [&](FigureVerdict verdict, bool flag, std::string message) {
            m_result.verdict = verdict;
            m_result.flag = flag;
            m_result.message = std::move(message);
        };
        if (isClamped && (sameMeans || found.correlation >= kSamePicture || m_plateau.value == 1))
            return set(FigureVerdict::Clamped, true,
                       fmt::format("Nothing in it is brighter than {:.4g}, where the code that was "
                                   "handed in renders more: bright parts were cut off.",
                                   m_plateau.value));
        // Noise moves the means of patches, too, but no more than their pixels.
        const bool isNoise = found.moreNoiseP <= kFigureLevel && found.smoothness < kOnlyNoise &&
                             found.correlation > kSimilar;
        if (!sameMeans && !isNoise)
            return decideDifference(found, set);
        const bool noiseCounts = countsNoise();
        if (noiseCounts && found.moreNoiseP <= kFigureLevel)
            return set(FigureVerdict::DifferentNoise, true,
                       fmt::format("The same picture with {:.2g} times the variance of {} samples "
                                   "per pixel: about {:.2g} samples.",
                                   found.noiseRatio, m_figure.samples,
                                   m_figure.samples / found.noiseRatio));
        if (noiseCounts && found.lessNoiseP <= kFigureLevel)
            return set(FigureVerdict::DifferentNoise, true, lessNoise(found));
        if (found.meanMde <= 0 || found.meanMde > kUsefulMde)
            return set(FigureVerdict::CannotTell, false,
                       fmt::format("{} patches of it show noise or a difference, and nothing tells "
                                   "them from the code's renders; but {}.",
                                   found.patches,
                                   found.meanMde > 0 ? "they are very noisy" : "they are too few"));
        std::string noise;
        if (noiseCounts)
            noise = fmt::format(
                "; noise {:.2f} times the expected (from {:.2g}{} would be found)",
                found.noiseRatio, found.moreNoiseMde,
                found.lessNoiseMde > 0 ? fmt::format(", or {:.2g},", found.lessNoiseMde) : "");
        set(FigureVerdict::Match, false,
            fmt::format("{} patches agree with what the code that was handed in renders with {} "
                        "samples per pixel: mean {:+.2f} % ({:.2g} % everywhere would be found){}.",
                        found.patches, m_rendered, 100 * found.meanError, 100 * found.meanMde,
                        noise));
    }

    std::string lessNoise(const FigureFindings &found) const {
        const double inPatches = found.noiseRatio * found.smoothness;
        if (found.smoothness > kSmoothed && inPatches > kKept)
            return fmt::format("The same picture, but its noise is only in large spots ({:.2g} "
                               "times the expected variance in pixels, {:.2g} in patches): it was "
                               "smoothed.",
                               found.noiseRatio, inPatches);
        if (found.noiseRatio < 1e-3)
            return "The same picture, without the noise that its samples make.";
        return fmt::format("The same picture with {:.2g} times the variance of {} samples per "
                           "pixel: about {:.2g} samples, another estimator, or smoothed.",
                           found.noiseRatio, m_figure.samples, m_figure.samples / found.noiseRatio);
    }

    template <typename Set>
    void decideDifference(const FigureFindings &found, const Set &set) {
        const std::string &scene = m_figure.scene.scene;
        const std::string other = found.correlation < kOtherScene ? sceneShown(found) : "";
        if (!other.empty())
            return set(FigureVerdict::DifferentScene, true,
                       fmt::format("It shows {}, not {}.", other, scene));
        const bool samePicture = found.correlation >= kSamePicture;
        std::string what =
            samePicture
                ? fmt::format("It shows {}, but not as the code that was handed in renders it: its "
                              "mean is {:.4f} times as large (correlation of {} patches {:.3f}).",
                              scene, 1 + found.meanError, found.patches, found.correlation)
                : fmt::format("It does not show {} as the code that was handed in renders it "
                              "(correlation of {} patches {:.2f}).",
                              scene, found.patches, found.correlation);
        if (m_check.scenes.given())
            return set(samePicture ? FigureVerdict::DifferentValues : FigureVerdict::DifferentScene,
                       true, std::move(what));
        what += " That was norigrade's own scene, which may differ from the one that was handed "
                "out: --scenes DIR names the folder of those.";
        set(FigureVerdict::CannotTell, false, std::move(what));
    }

    /// The other scene that the figure shows; empty: none of them.
    std::string sceneShown(const FigureFindings &named) {
        std::string best;
        double bestCorrelation =
            std::max(kOtherScene, 1 - kClearlyBetter * (1 - named.correlation));
        for (const std::string &scene : m_check.scenes.names()) {
            if (scene == m_figure.scene.scene)
                continue;
            try {
                const auto renders = render(bundleOf(scene), 4, scene);
                const double found = renders ? examine(*renders).correlation : 0;
                if (found > bestCorrelation) {
                    bestCorrelation = found;
                    best = scene;
                }
            } catch (const GraderError &) {
                continue; // a scene that cannot be read is not the one
            }
        }
        return best;
    }

    const StatedFigure &m_figure;
    const FigureCheck &m_check;
    const std::string &m_seed;
    PixelScale m_scale = PixelScale::Linear;
    PatchPlan m_plan;
    std::size_t m_tested = 0; ///< patches of the tests; spots of the plateau follow
    Plateau m_plateau;
    std::string m_lookSeed;
    double m_lessNoiseMde = 0; ///< of the last look
    int m_samples = 0;         ///< wanted of a render
    int m_rendered = 0;        ///< what it got
    std::string m_trouble;
    FigureResult m_result;
};

} // namespace

FigureResult judgeFigure(const StatedFigure &figure, const FigureCheck &check,
                         const std::string &seed) {
    try {
        return Judge(figure, check, seed).judge();
    } catch (const GraderError &error) { // a scene that cannot be read
        FigureResult result;
        result.verdict = FigureVerdict::CannotTell;
        result.message = error.what();
        return result;
    }
}

} // namespace grader
