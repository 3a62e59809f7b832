// SPDX-License-Identifier: MIT
#include <grader/checks/image_scene.h>
#include <statistics/binomial.h>
#include <statistics/random.h>

#include <fmt/core.h>

#include <set>

#include "planted.h"
#include "runs.h"

namespace calibration {

namespace {

using grader::CheckResult;
using grader::Verdict;

/// Answers with recorded samples: the grader's own judgement runs on them.
class RecordedContext : public grader::CheckContext {
public:
    RecordedContext(const Recording &student, const Recording &ours, std::uint64_t seed)
        : m_student(student), m_ours(ours), m_seed(seed) {}

    grader::ProbeAnswer ask(const protocol::RequestGroup &group) override {
        return answer(m_student, group);
    }

    grader::ProbeAnswer askReference(const protocol::RequestGroup &group) override {
        return answer(m_ours, group);
    }

    std::uint64_t seed(std::string_view purpose, int stage, int replicate) const override {
        m_stages.insert(stage);
        return statistics::deriveSeed(m_seed, purpose, static_cast<unsigned>(stage),
                                      static_cast<unsigned>(replicate));
    }

    /// Whether a stage was begun; 0 to 2 judge the whole image, 3 to 5 what stands out of it.
    bool hasBegun(int stage) const { return m_stages.count(stage) != 0; }

private:
    static grader::ProbeAnswer answer(const Recording &from, const protocol::RequestGroup &group) {
        grader::ProbeAnswer result;
        result.outcome.end = grader::BoxExited{0};
        for (const protocol::Request &request : group.requests) {
            statistics::Random random(request.seed);
            result.responses.push_back({protocol::State::Done, "", 0,
                                        from.samples(request.values, request.repeats, random)});
        }
        return result;
    }

    const Recording &m_student;
    const Recording &m_ours;
    std::uint64_t m_seed;
    mutable std::set<int> m_stages;
};

struct Ends {
    int fail = 0, pass = 0, open = 0;
    double mde = 0; ///< of the last look, largest channel, mean over the judgements
};

Ends judge(const Recording &student, const Recording &ours, int judgements, std::uint64_t seed) {
    Ends ends;
    for (int i = 0; i < judgements; ++i) {
        RecordedContext context(
            student, ours, statistics::deriveSeed(seed, "judgement", 0, static_cast<unsigned>(i)));
        const CheckResult result = grader::judgeRadiance(context, grader::imageCase({}, 256));
        ends.fail += result.verdict == Verdict::Fail ? 1 : 0;
        ends.pass += result.verdict == Verdict::Pass ? 1 : 0;
        ends.open += result.verdict == Verdict::Inconclusive ? 1 : 0;
        ends.mde += result.mde / judgements;
    }
    return ends;
}

/// Whether mistakes that must be found were: in 99.9 % of the judgements, within the binomial
/// 99.9 % limits.
bool isKept(Asked asked, int fail, int judgements) {
    if (asked == Asked::Nothing)
        return true;
    if (asked == Asked::NoFail)
        return fail == 0;
    const auto count = static_cast<std::uint64_t>(judgements);
    return statistics::clopperPearson(static_cast<std::uint64_t>(fail), count, 1e-3).upper >= 0.999;
}

} // namespace

bool runJudgements(int judgements, const std::string &only, std::uint64_t seed) {
    bool good = true;
    const Recording ours(kPlantedScene, seed);
    fmt::print(
        "Whole judgements of the same scene, {} each (a pass states: within 2 % as a whole, 15 "
        "% in a tile):\n",
        judgements);
    for (const Planted &mistake : plantedMistakes(only)) {
        Recording student(kPlantedScene, seed, mistake.integrator);
        student.plant(mistake.change);
        const Ends ends = judge(student, ours, judgements, seed);
        const bool kept = isKept(mistake.asked, ends.fail, judgements);
        good = good && kept;
        fmt::print("  {:<30} fail {:>3}, pass {:>3}, inconclusive {:>3}; would find {:.2g} %  {}\n",
                   mistake.name, ends.fail, ends.pass, ends.open, 100 * ends.mde,
                   mistake.asked == Asked::Nothing ? "(not asked for)"
                   : kept                          ? "ok"
                                                   : "OFF");
        std::fflush(stdout);
    }
    return good;
}

void runStages(int judgements, std::uint64_t seed) {
    fmt::print("Whole judgements of correct code, {} per scene: how many first stages reject, at a "
               "level of 1e-4\n",
               judgements);
    int begun = 0;
    int rejections = 0;
    for (const std::string &scene : sceneNames()) {
        const Recording recording(scene, seed);
        int whole = 0;
        int looks = 0;
        int again = 0;
        for (int i = 0; i < judgements; ++i) {
            RecordedContext context(
                recording, recording,
                statistics::deriveSeed(seed, "stages/" + scene, 0, static_cast<unsigned>(i)));
            grader::judgeRadiance(context, grader::imageCase({}, 256));
            whole += context.hasBegun(1) ? 1 : 0;
            looks += context.hasBegun(3) ? 1 : 0;
            again += context.hasBegun(4) ? 1 : 0;
        }
        begun += judgements + looks;
        rejections += whole + again;
        fmt::print("  {:<7} {} of {} of the whole image, {} of {} of what stands out\n", scene,
                   whole, judgements, again, looks);
        std::fflush(stdout);
    }
    fmt::print("  together {} of {}: below {:.2g} (one-sided 95 %); for "
               "grading/grader/calibration/stage_levels.toml\n",
               rejections, begun,
               statistics::clopperPearson(static_cast<std::uint64_t>(rejections),
                                          static_cast<std::uint64_t>(begun), 0.1)
                   .upper);
}

} // namespace calibration
