// SPDX-License-Identifier: MIT
#include <grader/checks/image_scene.h>
#include <grader/checks/radiance_comparison.h>
#include <statistics/binomial.h>
#include <statistics/tile_welch.h>

#include <boost/math/distributions/normal.hpp>
#include <fmt/core.h>

#include <array>
#include <cmath>

#include "recording.h"
#include "runs.h"

namespace calibration {

namespace {

using grader::CheckResult;
using grader::RadianceMoments;
using grader::Verdict;

constexpr int kReference = 3;
constexpr int kTileSize = 8;
constexpr int kLights = 5; ///< of the scene `table`
/// Of one statistic of a first stage, as in radiance_comparison.cpp.
constexpr double kLevel = 1e-4 / (grader::kLooks * 2 * 3 * 3);

void scale(float *color, double factor) {
    for (int c = 0; c < 3; ++c)
        color[c] *= static_cast<float>(factor);
}

/// What whole judgements must come to.
enum class Asked {
    Nothing, ///< the error lies below what a judgement promises to find
    NoFail,  ///< right code
    AllFail, ///< the error lies above it
};

/// A mistake, as what it does to a sample of a pixel.
struct Planted {
    const char *name;
    std::function<void(std::size_t, float *)> change;
    Asked asked = Asked::AllFail;
    const char *integrator = "direct_ems";
};

std::size_t tileOf(std::size_t pixel) {
    return pixel / kSide / kTileSize * (kSide / kTileSize) + pixel % kSide / kTileSize;
}

std::vector<Planted> mistakes() {
    std::vector<Planted> result = {{"nothing", [](std::size_t, float *) {}, Asked::NoFail}};

    struct Factor {
        const char *name;
        double value;
        Asked asked;
    };

    // A judgement that has found the image within 2 % looks no further.
    for (const Factor &factor : {Factor{"0.5 % brighter", 1.005, Asked::Nothing},
                                 Factor{"1 % brighter", 1.01, Asked::Nothing},
                                 Factor{"2 % brighter", 1.02, Asked::AllFail},
                                 Factor{"5 % brighter", 1.05, Asked::AllFail}})
        result.push_back({factor.name,
                          [value = factor.value](std::size_t, float *c) { scale(c, value); },
                          factor.asked});
    result.push_back({"one tile 10 % brighter", [](std::size_t pixel, float *c) {
                          scale(c, tileOf(pixel) == 9 ? 1.1 : 1);
                      }});
    result.push_back({"a black pixel", [](std::size_t pixel, float *c) {
                          scale(c, pixel == 20 * kSide + 12 ? 0 : 1);
                      }});
    result.push_back({"tiles 3 % brighter and darker", [](std::size_t pixel, float *c) {
                          const std::size_t tile = tileOf(pixel);
                          scale(c, (tile + tile / 4) % 2 == 0 ? 1.03 : 0.97);
                      }});
    result.push_back({"1 / lights forgotten", [](std::size_t, float *c) {
                          scale(c, 1.0 / kLights);
                      }});
    result.push_back(
        {"shadow margin of 0.6", [](std::size_t, float *) {}, Asked::AllFail, "wide_margin"});
    return result;
}

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
        return statistics::deriveSeed(m_seed, purpose, static_cast<unsigned>(stage),
                                      static_cast<unsigned>(replicate));
    }

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
};

/// Power of the two-sided test of the image's mean at kLevel.
double promised(double relativeError, double relativeNoise) {
    const boost::math::normal normal;
    const double needed = quantile(complement(normal, kLevel / 2));
    const double z = relativeError / relativeNoise;
    return cdf(normal, z - needed) + cdf(normal, -z - needed);
}

/// The mean of the image alone, at a fixed number of samples: what a minimal detectable error is
/// computed for.
bool powerOfMean(const Recording &student, const Recording &ours, const Planted &planted,
                 double error, int repeats, int runs, statistics::Random &random) {
    std::size_t found = 0;
    double noise = 0;
    double mde = 0;
    for (int run = 0; run < runs; ++run) {
        const RadianceMoments a = student.draw(repeats, random);
        const RadianceMoments b = ours.draw(kReference * repeats, random);
        const statistics::TileWelchResult result =
            statistics::tileWelchTest({kSide, kSide, a[1]}, {kSide, kSide, b[1]},
                                      {.tileSize = kTileSize, .significance = kLevel});
        found += result.global.pValue <= kLevel ? 1 : 0;
        noise += result.global.standardError / result.referenceMean / runs;
        mde += result.globalMde / runs;
    }
    const double wanted = promised(error, noise);
    const statistics::Interval limits =
        statistics::clopperPearson(found, static_cast<std::uint64_t>(runs), 1e-3);
    // The noise that the promise is made of is itself known to a few per cent only.
    const bool kept =
        limits.lower <= wanted + 0.02 && wanted - 0.02 <= limits.upper &&
        (std::fabs(error) < mde || found * 1000 >= 995u * static_cast<unsigned>(runs));
    fmt::print("  {:<16} {:>5} samples: found {:>6.2f} %, promised {:>6.2f} %, would find {:.2f} "
               "%  {}\n",
               planted.name, repeats, 100 * static_cast<double>(found) / runs, 100 * wanted,
               100 * mde, kept ? "ok" : "OFF");
    return kept;
}

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

} // namespace

bool runPower(int runs, int judgements, std::uint64_t seed) {
    bool good = true;
    const std::string scene = "table";
    const Recording ours(scene, seed);
    statistics::Random random(statistics::deriveSeed(seed, "power"));
    const std::array<double, 5> errors = {0, 0.005, 0.01, 0.02, 0.05};
    const std::vector<Planted> planted = mistakes();
    fmt::print("The mean of {}'s image alone, {} runs each, at a level of {:.2g}:\n", scene, runs,
               kLevel);
    for (std::size_t i = 0; i < errors.size(); ++i) {
        Recording student = ours;
        student.plant(planted[i].change);
        for (const int repeats : {64, 256, 1024})
            good = powerOfMean(student, ours, planted[i], errors[i], repeats,
                               std::max(10, runs * 64 / repeats), random) &&
                   good;
        std::fflush(stdout);
    }
    fmt::print("Whole judgements of the same scene, {} each (a pass means: within 2 %):\n",
               judgements);
    for (const Planted &mistake : planted) {
        Recording student(scene, seed, mistake.integrator);
        student.plant(mistake.change);
        const Ends ends = judge(student, ours, judgements, seed);
        const bool kept = mistake.asked == Asked::Nothing ||
                          ends.fail == (mistake.asked == Asked::NoFail ? 0 : judgements);
        good = good && kept;
        fmt::print("  {:<30} fail {:>3}, pass {:>3}, inconclusive {:>3}; would find {:.2g} %  {}\n",
                   mistake.name, ends.fail, ends.pass, ends.open, 100 * ends.mde,
                   kept ? "ok" : "OFF");
        std::fflush(stdout);
    }
    return good;
}

} // namespace calibration
