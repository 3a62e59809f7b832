// SPDX-License-Identifier: MIT
//
// Relations between images of one program: what has to hold whatever the scene looks like, and
// needs no reference.
#include <grader/checks/answer.h>
#include <grader/checks/image_scene.h>
#include <grader/checks/radiance_comparison.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "check_groups.h"
#include "radiance_check.h"

namespace grader {

namespace {

constexpr int kRepeats = 192;
constexpr double kPassBound = 0.03;
constexpr double kFactor = 3.7;
/// Part of the samples that may differ when a scene is lit more strongly: where rounding of a
/// probability makes another choice.
constexpr double kOtherChoices = 1e-3;

/// Two images that must have the same mean; several on a side are summed up.
struct Relation {
    const char *name;
    const char *what;
    const char *diagnosis; ///< id
    std::vector<SceneVariation> left;
    std::vector<SceneVariation> right;
};

std::vector<Relation> relations() {
    const auto dark = [](std::vector<std::size_t> lights) {
        SceneVariation variation;
        variation.darkLights = std::move(lights);
        return variation;
    };
    SceneVariation moved;
    moved.pose = 1;
    SceneVariation cut;
    cut.cuts = 2;
    return {
        {"moved",
         "Moving and turning the whole scene leaves its image as it is.",
         "ems.depends_on_place",
         {{}},
         {moved}},
        {"cut",
         "Cutting lights and surfaces into more triangles leaves the image as it is.",
         "ems.depends_on_triangles",
         {{}},
         {cut}},
        {"added",
         "Two images with some of the lights each add up to the one with all lights.",
         "ems.light_left_out",
         {dark({0, 1}), dark({2, 3, 4})},
         {{}}},
    };
}

/// Moments of the sum of images with the same number of samples.
RadianceMoments sum(const std::vector<RadianceMoments> &images) {
    RadianceMoments result = images[0];
    for (std::size_t k = 1; k < images.size(); ++k) {
        for (std::size_t c = 0; c < 3; ++c) {
            for (std::size_t i = 0; i < result[c].size(); ++i) {
                result[c][i].mean += images[k][c][i].mean;
                result[c][i].variance += images[k][c][i].variance;
                result[c][i].thirdCentral += images[k][c][i].thirdCentral;
            }
        }
    }
    return result;
}

std::string folderOf(std::size_t image) {
    return fmt::format("image{}", image);
}

CheckResult judgeRelation(CheckContext &context, const Relation &relation) {
    const SceneTemplate scene = imageTemplate("table");
    std::vector<SceneVariation> variations = relation.left;
    variations.insert(variations.end(), relation.right.begin(), relation.right.end());
    protocol::RequestGroup group;
    for (std::size_t i = 0; i < variations.size(); ++i) {
        for (protocol::File &file : scene.fill(context.seed("scene"), variations[i], folderOf(i)))
            group.files.push_back(std::move(file));
    }
    std::optional<CheckResult> early;
    Comparison found;
    int repeats = 0;
    const auto stage = [&](const statistics::StageRequest &request) {
        repeats = kRepeats * request.sampleFactor;
        group.requests.clear();
        for (std::size_t i = 0; i < variations.size(); ++i)
            group.requests.push_back(imageRequest(
                folderOf(i), repeats,
                context.seed("samples", static_cast<int>(request.index), static_cast<int>(i))));
        const ProbeAnswer answer = context.ask(group);
        if ((early = unanswered(answer))) {
            found.stage.reliable = false;
            return found.stage;
        }
        std::vector<RadianceMoments> sides[2];
        for (std::size_t i = 0; i < variations.size(); ++i) {
            RadianceSamples samples(std::size_t{kImageSize} * kImageSize);
            samples.add(answer.responses[i].values, repeats);
            sides[i < relation.left.size() ? 0 : 1].push_back(momentsOf(samples));
        }
        found = compareImages(sum(sides[0]), sum(sides[1]), kImageSize, 8);
        return found.stage;
    };
    const statistics::LockResult lock = statistics::tripleLock(
        stage, {.tolerance = kGlobalTolerance, .passLimit = kPassBound, .sampleFactor = {1, 2, 4}});
    if (early)
        return *early;
    CheckResult result = makeResult(
        Verdict::Inconclusive,
        fmt::format("{} pixels of {} samples: the two sides' ratio is {:.4f} +- {:.4f} (off by "
                    "{:.2g} % at most; {:.2g} % would be found); the tiles differ by {:.2g} % rms.",
                    kImageSize * kImageSize, repeats, found.factor, found.factorError,
                    100 * found.stage.effectBound, 100 * found.stage.mde,
                    100 * found.stage.effect));
    result.effect = found.stage.effect;
    result.mde = found.stage.mde;
    result.p = found.stage.pValue;
    if (lock.decision == statistics::Decision::Pass)
        result.verdict = Verdict::Pass;
    if (lock.decision == statistics::Decision::Fail) {
        result.verdict = Verdict::Fail;
        result.diagnoses = {{relation.diagnosis, 0.6}};
    }
    return result;
}

/// Part of the samples that are not `factor` times the others.
double differingPart(const std::vector<float> &a, const std::vector<float> &b, double factor) {
    double differing = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double wanted = factor * static_cast<double>(a[i]);
        if (!(std::abs(static_cast<double>(b[i]) - wanted) <= 1e-3 * std::abs(wanted)))
            ++differing;
    }
    return differing / static_cast<double>(a.size());
}

/// Whether the same random numbers choose the same lights in the scenes of two folders: the part of
/// them that does not. 0 if the code does not say.
double differingChoices(CheckContext &context, const std::vector<protocol::File> &files,
                        const std::string &folder, const std::string &other) {
    constexpr int kDraws = 4096;
    SceneRandom random(context.seed("choices"));
    protocol::RequestGroup group;
    group.files = files;
    protocol::Request request;
    request.op = protocol::Op::EmitterPick;
    for (int i = 0; i < kDraws; ++i)
        request.values.push_back(random.nextFloat());
    for (const std::string &place : {folder, other}) {
        request.text = place + "/" + TestScene::kFileName;
        group.requests.push_back(request);
    }
    const ProbeAnswer answer = context.ask(group);
    if (!answer.complete())
        return 0;
    const std::vector<float> &picks = answer.responses[0].values;
    const std::vector<float> &others = answer.responses[1].values;
    int differing = 0;
    for (std::size_t at = 0; at < std::min(picks.size(), others.size());
         at += protocol::kEmitterPickSize)
        differing += picks[at] == others[at] ? 0 : 1;
    return static_cast<double>(differing) / kDraws;
}

/// With the same random numbers, k times as strong lights give k times every single sample.
CheckResult judgeScaled(CheckContext &context) {
    const SceneTemplate scene = imageTemplate("table");
    const std::uint64_t sceneSeed = context.seed("scene");
    SceneVariation strong;
    strong.radianceFactor = kFactor;
    protocol::RequestGroup group;
    for (const auto &[variation, folder] :
         {std::pair{SceneVariation{}, folderOf(0)}, std::pair{strong, folderOf(1)}}) {
        for (protocol::File &file : scene.fill(sceneSeed, variation, folder))
            group.files.push_back(std::move(file));
    }
    const std::uint64_t seed = context.seed("samples");
    for (const int image : {0, 1, 0})
        group.requests.push_back(
            imageRequest(folderOf(static_cast<std::size_t>(image)), kRepeats / 4, seed));
    const ProbeAnswer answer = context.ask(group);
    if (auto early = unanswered(answer))
        return *early;
    const std::vector<float> &plain = answer.responses[0].values;
    const std::vector<float> &again = answer.responses[2].values;
    // What is not a number differs from itself; that is another check's to say.
    const double unstable = differingPart(plain, again, 1);
    if (unstable > kOtherChoices)
        return makeResult(
            Verdict::Inconclusive,
            fmt::format("{:.2g} % of the samples differ when the same random numbers are given "
                        "again: are others used, rand() for instance?",
                        100 * unstable));
    // Probabilities that do not scale are the choice's fault, and judged with it.
    const double otherwise = differingChoices(context, group.files, folderOf(0), folderOf(1));
    if (otherwise > kOtherChoices)
        return makeResult(Verdict::Inconclusive,
                          fmt::format("With lights {} times as strong, {:.2g} % of the random "
                                      "numbers choose another light: samples cannot be compared.",
                                      kFactor, 100 * otherwise));
    const double differing = differingPart(plain, answer.responses[1].values, kFactor);
    CheckResult result = makeResult(
        differing <= kOtherChoices ? Verdict::Pass : Verdict::Fail,
        fmt::format("With lights {} times as strong, {:.2g} % of {} samples are not {} times as "
                    "large.",
                    kFactor, 100 * differing, plain.size() / 3, kFactor));
    result.effect = differing;
    result.mde = kOtherChoices;
    result.diagnoses = {{"ems.clamped", 0.9}};
    return result;
}

} // namespace

std::vector<Check> relationChecks() {
    constexpr double kTolerance = 0.005;
    constexpr double kGross = 0.05;
    std::vector<Check> checks = {
        directEmsCheck("scaled", "Lights k times as strong make every sample k times as large.",
                       judgeScaled, kTolerance, kGross)};
    for (const Relation &relation : relations()) {
        const auto run = [relation](CheckContext &context) {
            return judgeRelation(context, relation);
        };
        checks.push_back(directEmsCheck(relation.name, relation.what, run, kTolerance, kGross));
        checks.back().evidence = Evidence::Images;
    }
    return checks;
}

} // namespace grader
