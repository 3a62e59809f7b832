// SPDX-License-Identifier: MIT
#include <grader/checks/image_scene.h>
#include <statistics/binomial.h>

#include <fmt/core.h>

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>

#include "contexts.h"
#include "runs.h"

namespace calibration {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kJudgementsPerScene = 100; ///< where our renderer answers: loading takes long

/// First stages, and those of them that rejected.
struct StageCount {
    std::uint64_t begun = 0;
    std::uint64_t rejections = 0;

    double rate() const {
        return begun == 0 ? 0 : static_cast<double>(rejections) / static_cast<double>(begun);
    }

    double bound() const { return statistics::clopperPearson(rejections, begun, 0.1).upper; }
};

/// What is judged again and again.
struct Part {
    std::string name;
    std::function<grader::CheckResult(grader::CheckContext &)> judge;
    std::vector<int> firstStages; ///< numbers of those that begin three stages each
    std::string scene;            ///< whose recorded samples answer; empty: our renderer does
};

/// One kind of evidence of stage_levels.toml.
struct Kind {
    std::string evidence;
    std::vector<Part> parts;
};

const std::vector<int> kRadianceStages = {0, grader::kSuspectsFirstStage};

/// The check itself.
Part checkPart(const std::string &id, const std::string &scene,
               const std::vector<int> &firstStages = {0}) {
    const grader::Check *check = grader::findCheck(id);
    if (check == nullptr)
        throw std::runtime_error("there is no check " + id);
    return {id, check->run, firstStages, scene};
}

std::vector<Kind> kinds() {
    Kind images{"images", {}};
    for (const std::string &scene : sceneNames()) {
        const auto judge = [](grader::CheckContext &context) {
            return grader::judgeRadiance(context, grader::imageCase({}, 256));
        };
        images.parts.push_back({scene, judge, kRadianceStages, scene});
    }
    // Most of these against a closed form, which has no noise of its own: there skewness does not
    // cancel.
    for (const char *name :
         {"point_lights", "area_light", "many_lights", "visible_light", "background",
          "light_behind", "reflecting_light", "large_scene", "near_shadow", "far_shadow"})
        images.parts.push_back(checkPart(std::string("direct_ems.") + name, "", kRadianceStages));
    return {{"cells",
             {checkPart("mesh.uniform", ""), checkPart("mesh.unequal", ""),
              checkPart("environment.distribution", "")}},
            images,
            {"noise", {checkPart("direct_ems.independence", "box")}}};
}

/// Answers for one part: right ones, and those of a twin that must be rejected.
class Answers {
public:
    Answers(const Part &part, std::uint64_t seed) : m_seed(seed), m_name(part.name) {
        if (part.scene.empty())
            return;
        m_right.emplace(part.scene, seed);
        m_wrong.emplace(*m_right);
        m_wrong->plant([](std::size_t, float *color) {
            for (int i = 0; i < 3; ++i)
                color[i] *= 1.2F;
        });
    }

    std::unique_ptr<LocalContext> context(int judgement, bool isTwin) {
        const std::uint64_t seed = seedOf("", judgement);
        if (m_right)
            return std::make_unique<RecordedContext>(isTwin ? *m_wrong : *m_right, *m_right, seed);
        return std::make_unique<OwnContext>(
            m_scenes, seedOf("/scene", judgement / kJudgementsPerScene), seed, isTwin);
    }

private:
    std::uint64_t seedOf(const char *what, int number) const {
        return statistics::deriveSeed(m_seed, "stages/" + m_name + what, 0,
                                      static_cast<unsigned>(number));
    }

    std::uint64_t m_seed;
    std::string m_name;
    std::optional<Recording> m_right, m_wrong;
    LoadedScenes m_scenes;
};

/// \return  a count for each of the part's first stages
/// \throws std::runtime_error  if the twin is not rejected, or right code is accused
std::vector<StageCount> countStages(const Part &part, int judgements, std::uint64_t seed) {
    Answers answers(part, seed);
    const std::unique_ptr<LocalContext> twin = answers.context(0, true);
    const grader::CheckResult wrong = part.judge(*twin);
    if (!twin->hasBegun(1))
        throw std::runtime_error(part.name + ": what is wrong is not rejected: " + wrong.message);
    std::vector<StageCount> counts(part.firstStages.size());
    const Clock::time_point begin = Clock::now();
    Clock::time_point told = begin;
    for (int i = 0; i < judgements; ++i) {
        if (const Clock::time_point now = Clock::now(); now - told > std::chrono::seconds(10)) {
            told = now;
            fmt::print(stderr, "{}: {} of {}, {:.0f} s left\n", part.name, i, judgements,
                       std::chrono::duration<double>(now - begin).count() / i * (judgements - i));
        }
        const std::unique_ptr<LocalContext> context = answers.context(i, false);
        const grader::CheckResult result = part.judge(*context);
        if (result.verdict != grader::Verdict::Pass &&
            result.verdict != grader::Verdict::Inconclusive)
            throw std::runtime_error(part.name + ": correct code is accused: " + result.message);
        for (std::size_t k = 0; k < counts.size(); ++k) {
            counts[k].begun += context->hasBegun(part.firstStages[k]) ? 1 : 0;
            counts[k].rejections += context->hasBegun(part.firstStages[k] + 1) ? 1 : 0;
        }
    }
    return counts;
}

} // namespace

void runStages(int judgements, const std::string &only, std::uint64_t seed) {
    fmt::print("Whole judgements of correct code, {} per scene or check: how many first stages "
               "reject, at a level of 1e-4\n",
               judgements);
    for (const Kind &kind : kinds()) {
        if (kind.evidence.find(only) == std::string::npos)
            continue;
        std::optional<StageCount> worst;
        std::string worstName;
        for (const Part &part : kind.parts) {
            const std::vector<StageCount> counts = countStages(part, judgements, seed);
            for (std::size_t k = 0; k < counts.size(); ++k) {
                const std::string name =
                    part.name + (part.firstStages[k] == 0 ? "" : ", what stands out");
                fmt::print("  {:<44} {} of {}\n", name, counts[k].rejections, counts[k].begun);
                // By the rate: what seldom stands out has a wide limit and says little.
                if (!worst || counts[k].rate() > worst->rate()) {
                    worst = counts[k];
                    worstName = name;
                }
            }
            std::fflush(stdout);
        }
        fmt::print("{}: of {} parts, most of {}: {} of {} reject, below {:.2g} (one-sided 95 %); "
                   "for grading/grader/calibration/stage_levels.toml\n",
                   kind.evidence, kind.parts.size(), worstName, worst->rejections, worst->begun,
                   worst->bound());
    }
}

} // namespace calibration
