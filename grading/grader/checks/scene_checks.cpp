// SPDX-License-Identifier: MIT
#include <grader/checks/answer.h>
#include <grader/scenes/test_scene.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "check_groups.h"

namespace grader {

namespace {

constexpr int kDraws = 1 << 17;
/// Absolute, of a probability: binomial noise of kDraws is at most 0.0014, a wrong density is off
/// by far more.
constexpr double kTolerance = 0.008;

/// Lights of every kind, so that none is left out of the choice.
TestScene makeScene(std::uint64_t seed) {
    SceneRandom random(seed);
    const Eigen::Isometry3d pose = random.rigid(1);
    TestScene scene("normals");
    scene.addFile(kSkyMapName, skyMap());
    for (int i = 0; i < 3; ++i)
        scene.addPointLight(pose * Vector3d(i - 1.0, 0.3 * i, 1.5), random.color(0.5, 2 + 3 * i));
    scene.addEnvironment({255, 230, 200}, kSkyMapName);
    for (int i = 0; i < 2; ++i)
        scene.addLight(
            parallelogram({-1.0 + i, 0, 2}, {0.5 + i, 0, 0}, {0, 0.4, 0}).transformed(pose),
            {0.5, 0.5, 0.5}, {.radiance = random.color(1, 5), .scale = {}, .texture = {}});
    scene.addMesh(parallelogram({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}).transformed(pose),
                  {0.5, 0.5, 0.5});
    return scene;
}

constexpr int kLights = 6;

struct Picks {
    std::vector<double> frequency = std::vector<double>(kLights);
    std::vector<double> returned = std::vector<double>(kLights); ///< pdf of sampleEmitter
    std::vector<double> asked = std::vector<double>(kLights);    ///< pdfEmitter
    double unknown = 0; ///< part of the draws that gave no light of the scene
    std::optional<CheckResult> failure;
};

Picks measurePicks(CheckContext &context) {
    SceneRandom random(context.seed("draws"));
    protocol::RequestGroup group;
    group.files = makeScene(context.seed("scene")).files();
    protocol::Request request;
    request.op = protocol::Op::EmitterPick;
    request.text = TestScene::kFileName;
    for (int i = 0; i < kDraws; ++i)
        request.values.push_back(random.nextFloat());
    group.requests.push_back(std::move(request));
    Picks picks;
    const ProbeAnswer answer = context.ask(group);
    picks.failure = unanswered(answer);
    if (picks.failure)
        return picks;
    const std::vector<float> &values = answer.responses[0].values;
    for (std::size_t at = 0; at < values.size(); at += protocol::kEmitterPickSize) {
        const auto light = static_cast<int>(values[at]);
        if (!(values[at] >= 0) || light >= kLights) {
            picks.unknown += 1.0 / kDraws;
            continue;
        }
        const auto i = static_cast<std::size_t>(light);
        picks.frequency[i] += 1.0 / kDraws;
        picks.returned[i] = values[at + 1];
        picks.asked[i] = values[at + 2];
    }
    return picks;
}

double largestDifference(const std::vector<double> &a, const std::vector<double> &b) {
    double worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double difference = std::abs(a[i] - b[i]);
        worst = std::isfinite(difference) ? std::max(worst, difference) : 1;
    }
    return worst;
}

bool isSame(const std::vector<double> &a, const std::vector<double> &b) {
    return largestDifference(a, b) <= kTolerance;
}

/// What a returned density is that is not the frequency of the light.
std::vector<Guess> guessPdf(const Picks &picks, const char *other) {
    const auto all = [&](const auto &right) {
        for (std::size_t i = 0; i < picks.returned.size(); ++i) {
            const double wanted = right(i);
            if (!(std::abs(picks.returned[i] - wanted) <= 0.05 * std::abs(wanted)))
                return false;
        }
        return true;
    };
    const double factor = picks.returned[0] / picks.frequency[0];
    if (all([&](std::size_t) { return 1.0 / kLights; }))
        return {{"importance.uniform_pdf"}};
    if (all([&](std::size_t i) { return 1 / picks.frequency[i]; }))
        return {{"importance.pdf_reciprocal"}};
    if (all([&](std::size_t i) { return factor * picks.frequency[i]; }))
        return {{std::abs(factor / kLights - 1) <= 0.05 ? other : "importance.unnormalised"}};
    return {{other, 0.5}};
}

CheckResult judgePick(CheckContext &context) {
    const Picks picks = measurePicks(context);
    if (picks.failure)
        return *picks.failure;
    if (picks.unknown > 0)
        return makeResult(Verdict::Fail,
                          fmt::format("In {:.2g} % of the draws sampleEmitter returns no light of "
                                      "the scene.",
                                      100 * picks.unknown),
                          {{"importance.built_too_early"}});
    const auto never = std::count(picks.frequency.begin(), picks.frequency.end(), 0.0);
    const double worst = largestDifference(picks.frequency, picks.returned);
    CheckResult result =
        makeResult(worst <= kTolerance && never == 0 ? Verdict::Pass : Verdict::Fail,
                   fmt::format("The returned probabilities differ from the frequencies by at most "
                               "{:.2g}; {} of {} lights are never chosen.",
                               worst, never, kLights));
    result.effect = worst;
    result.diagnoses = never > 0 ? std::vector<Guess>{{"importance.light_missing"}}
                                 : guessPdf(picks, "importance.pdf_mismatch");
    return result;
}

CheckResult judgePdfEmitter(CheckContext &context) {
    const Picks picks = measurePicks(context);
    if (picks.failure)
        return *picks.failure;
    const double worst = largestDifference(picks.frequency, picks.asked);
    CheckResult result =
        makeResult(worst <= kTolerance ? Verdict::Pass : Verdict::Fail,
                   fmt::format("pdfEmitter differs from the frequencies by at most {:.2g}.", worst),
                   {{"importance.pdf_emitter", 0.7}});
    // Right by what sampleEmitter says itself: then it is that which does not hold.
    if (isSame(picks.asked, picks.returned) && !isSame(picks.returned, picks.frequency))
        result.diagnoses = guessPdf(picks, "importance.pdf_mismatch");
    result.effect = worst;
    return result;
}

Check row(const char *name, const char *what, CheckResult (*run)(CheckContext &)) {
    Check check;
    check.id = std::string("scene.") + name;
    check.item = "emitter_importance";
    check.group = "scene";
    check.what = what;
    check.tolerance = 0.01;
    check.gross = 0.2;
    check.run = run;
    return check;
}

} // namespace

std::vector<Check> sceneChecks() {
    return {
        row("pick", "sampleEmitter returns the probability of its choice.", judgePick),
        row("pdf_emitter", "pdfEmitter agrees with sampleEmitter.", judgePdfEmitter),
    };
}

} // namespace grader
