// SPDX-License-Identifier: MIT
#include "radiance_case.h"

#include <grader/checks/answer.h>
#include <grader/checks/radiance_comparison.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace grader {

namespace {

/// Samples that the film would drop without a trace; more of them are a visible defect.
constexpr double kInvalidTolerance = 1e-4;
/// For code that is slower than ours by a large factor: a fraction of the samples will do.
constexpr std::array<int, 3> kFewerSamples = {1, 16, 256};
/// The first look takes this part of RadianceCase::repeats, the last one 16 times as many.
constexpr int kFirstLook = 4;
/// Further looks end here, as answers have to fit into memory: 3 floats each.
constexpr double kMostSamples = 1 << 25;
/// Samples of our own estimator per sample of the student's, for the comparison with "more".
constexpr int kReferenceFactor = 3;
/// What stands out by fewer standard errors than this is not looked at again: of 1024 pixels and
/// three channels, chance gives 3.7.
constexpr double kSuspicion = 4.5;
constexpr int kPixelFactor = 64;
constexpr int kTileFactor = 4;
constexpr int kMostRepeats = 512; ///< times these factors

/// Samples of both sides at the same places.
struct BothSides {
    RadianceSamples student;
    RadianceSamples equal; ///< of our own estimator, as many
    RadianceSamples more;  ///< and in all

    explicit BothSides(std::size_t places) : student(places), equal(places), more(places) {}

    void merge(const BothSides &other) {
        student.merge(other.student);
        equal.merge(other.equal);
        more.merge(other.more);
    }
};

/// One judgement: asks, looks, and remembers how it ended.
class Judge {
public:
    Judge(CheckContext &context, const RadianceCase &test) : m_context(context), m_test(test) {
        for (std::size_t c = 0; c < 3; ++c) {
            for (const Vector3d &value : test.expected) // a closed form has no noise
                m_exact[c].push_back({1e12, value[static_cast<Eigen::Index>(c)], 0, 0});
        }
    }

    CheckResult judge() {
        const statistics::LockResult lock = statistics::tripleLock(
            [&](const statistics::StageRequest &request) { return stage(request); },
            {.tolerance = kGlobalTolerance,
             .passLimit = m_test.passBound,
             .sampleFactor = {1, 2, 4}});
        if (m_early)
            return *m_early;
        CheckResult result = makeResult(Verdict::Inconclusive, sentence());
        result.effect = m_last.stage.effect;
        result.mde = m_last.stage.mde;
        result.p = m_last.stage.pValue;
        if (lock.decision == statistics::Decision::Pass && m_last.tileBound <= m_test.tilePassBound)
            result.verdict = Verdict::Pass;
        if (lock.decision == statistics::Decision::Fail) {
            result.verdict = Verdict::Fail;
            result.diagnoses = explain(lock, guessRadiance(m_student, m_expected, m_test.diagnoses),
                                       "ems.samples_reused");
        } else if (lookAtSuspects(result)) {
            result.diagnoses = {{m_test.diagnoses.other, m_test.diagnoses.otherFit}};
        }
        if (m_early)
            return *m_early;
        countInvalid(result);
        return result;
    }

private:
    /// Looks at samples that double, each at its part of the level.
    statistics::StageResult stage(const statistics::StageRequest &request) {
        BothSides all(m_test.places());
        int taken = 0;
        for (int look = 0; look < kLooks; ++look) {
            const int wanted = std::max(4, m_test.repeats * request.sampleFactor / kFirstLook)
                               << look;
            if (look > 0 && wanted * static_cast<double>(m_test.places()) > kMostSamples)
                break;
            const auto index = static_cast<int>(request.index);
            if (!take(all, {}, wanted - taken, kReferenceFactor, index, look))
                return unreliable();
            taken = wanted;
            m_last = compare(all);
            m_last.stage.pValue = std::min(1.0, kLooks * m_last.stage.pValue);
            m_repeats =
                static_cast<int>(all.student.count().all / static_cast<double>(m_test.places()));
            const bool rejects = m_last.stage.pValue <= request.significance;
            const bool passes = m_last.stage.effectBound <= m_test.passBound &&
                                m_last.tileBound <= m_test.tilePassBound;
            if (m_slow || (m_last.stage.reliable && (rejects || passes)))
                break;
        }
        m_counts = all.student.count();
        m_student = momentsOf(all.student);
        m_expected = m_test.expected.empty() ? momentsOf(all.more) : m_exact;
        return m_last.stage;
    }

    /// Adds samples of both sides, `ours` of our own for each.
    /// \return  false if there are none: m_early says why
    bool take(BothSides &sides, const std::vector<std::size_t> &which, int repeats, int ours,
              int stage, int replicate) {
        BothSides taken(sides.student.places());
        const auto request = [&](int count, const char *who) {
            return radianceRequest(m_test, count, m_context.seed(who, stage, replicate), which);
        };
        ProbeAnswer answer;
        int count = 0;
        for (; m_divisor < kFewerSamples.size(); ++m_divisor) {
            m_slow = m_divisor > 0;
            count = std::max(2, repeats / kFewerSamples[m_divisor]);
            answer = m_context.ask(request(count, "student"));
            if (!std::holds_alternative<BoxTimedOut>(answer.outcome.end))
                break;
        }
        if ((m_early = unanswered(answer)))
            return false;
        taken.student.add(answer.responses[0].values, count);
        if (m_test.expected.empty()) {
            protocol::RequestGroup group = request(count, "reference");
            const int others = (ours - 1) * count;
            if (others > 0)
                group.requests.push_back(request(others, "more").requests[0]);
            const ProbeAnswer answered = m_context.askReference(group);
            if (const auto failure = unanswered(answered)) {
                m_early = makeResult(Verdict::Infra,
                                     "our own program gave no answer: " + failure->message);
                return false;
            }
            taken.equal.add(answered.responses[0].values, count);
            taken.more.merge(taken.equal);
            if (others > 0)
                taken.more.add(answered.responses[1].values, others);
        }
        sides.merge(taken);
        return true;
    }

    Comparison compare(const BothSides &sides) const {
        const RadianceMoments student = momentsOf(sides.student);
        if (!m_test.expected.empty())
            return compareImages(student, m_exact, m_test.columns, m_test.tileSize());
        // With more samples of ours the error is smaller; with equal ones the skewness cancels, and
        // the test keeps its level under any law.
        Comparison result =
            compareImages(student, momentsOf(sides.more), m_test.columns, m_test.tileSize());
        const Comparison equal =
            compareImages(student, momentsOf(sides.equal), m_test.columns, m_test.tileSize());
        result.stage.pValue = std::min(1.0, 2 * std::min(result.stage.pValue, equal.stage.pValue));
        result.stage.reliable = result.stage.reliable || equal.stage.reliable;
        return result;
    }

    /// Holes and edges that tiles dilute: chosen on the samples at hand, judged on fresh ones.
    /// \return  whether something is wrong there
    bool lookAtSuspects(CheckResult &result) {
        const Suspects suspects =
            findSuspects(m_student, m_expected, m_test.columns, m_test.tileSize());
        if (suspects.largest < kSuspicion || m_slow)
            return false;
        const int repeats = std::min(m_repeats, kMostRepeats);
        double mean = 0;
        for (const auto &channel : m_expected) {
            for (const statistics::MomentSummary &place : channel)
                mean += place.mean / (3 * static_cast<double>(m_test.places()));
        }
        const auto lookAt = [&](const std::vector<std::size_t> &which, int perGroup, int samples) {
            statistics::StageResult last;
            const statistics::LockResult lock = statistics::tripleLock(
                [&](const statistics::StageRequest &request) {
                    BothSides fresh(which.size());
                    if (!take(fresh, which, samples, 1,
                              kSuspectsFirstStage + static_cast<int>(request.index), perGroup))
                        return unreliable();
                    const RadianceMoments expected =
                        m_test.expected.empty() ? momentsOf(fresh.more) : pick(m_exact, which);
                    last = compareSuspects(momentsOf(fresh.student), expected, perGroup, mean,
                                           m_test.places());
                    last.pValue = std::min(1.0, 2 * last.pValue); // pixels and tiles
                    return last;
                },
                {.tolerance = kGlobalTolerance, .sampleFactor = {1, 1, 1}});
            if (m_early || lock.decision != statistics::Decision::Fail)
                return false;
            result.verdict = Verdict::Fail;
            result.effect = last.effect;
            result.p = last.pValue;
            return true;
        };
        if (!suspects.tiles.empty() &&
            lookAt(suspects.tiles, m_test.tileSize() * m_test.tileSize(), repeats * kTileFactor))
            return true;
        return !m_early && lookAt(suspects.pixels, 1, repeats * kPixelFactor);
    }

    void countInvalid(CheckResult &result) const {
        const double invalid = m_counts.invalidPart();
        if (invalid > kInvalidTolerance && result.verdict != Verdict::Fail) {
            result.verdict = Verdict::Fail;
            result.effect = invalid;
            result.diagnoses = {{"ems.not_finite", 0.9}};
        }
        result.message += m_counts.describe();
    }

    std::string sentence() const {
        return fmt::format(
            "{} {} of {} samples: the radiance is {:.4f} +- {:.4f} times what it must be "
            "(off by {:.2g} % at most; {:.2g} % would be found); the tiles differ by {:.2g} % rms, "
            "none by more than {:.2g} %.",
            m_test.places(), m_test.rays.empty() ? "pixels" : "rays", m_repeats, m_last.factor,
            m_last.factorError, 100 * m_last.stage.effectBound, 100 * m_last.stage.mde,
            100 * m_last.stage.effect, 100 * m_last.tileBound);
    }

    static statistics::StageResult unreliable() {
        statistics::StageResult result;
        result.reliable = false;
        return result;
    }

    CheckContext &m_context;
    const RadianceCase &m_test;
    RadianceMoments m_exact; ///< of RadianceCase::expected
    std::optional<CheckResult> m_early;
    Comparison m_last;
    int m_repeats = 0;
    SampleCount m_counts;
    RadianceMoments m_student;  ///< of the last stage
    RadianceMoments m_expected; ///< same
    std::size_t m_divisor = 0;  ///< into kFewerSamples
    bool m_slow = false;
};

} // namespace

protocol::RequestGroup radianceRequest(const RadianceCase &test, int repeats, std::uint64_t seed,
                                       const std::vector<std::size_t> &which) {
    protocol::RequestGroup group;
    group.files = test.files;
    protocol::Request request;
    request.op = test.rays.empty() ? protocol::Op::Image : protocol::Op::Radiance;
    request.text = TestScene::kFileName;
    request.repeats = static_cast<std::uint32_t>(repeats);
    request.seed = seed;
    const std::size_t count = which.empty() ? test.places() : which.size();
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t place = which.empty() ? i : which[i];
        if (test.rays.empty()) {
            request.values.push_back(static_cast<float>(place));
            continue;
        }
        for (const Vector3d &v : {test.rays[place].origin, test.rays[place].direction}) {
            for (int c = 0; c < 3; ++c)
                request.values.push_back(static_cast<float>(v[c]));
        }
    }
    group.requests.push_back(std::move(request));
    return group;
}

std::vector<TestRay> raysOnto(const TestMesh &parallelogram, int columns, double distance,
                              SceneRandom &random) {
    const Vector3d &corner = parallelogram.positions[0];
    const Vector3d a = parallelogram.positions[1] - corner;
    const Vector3d b = parallelogram.positions[3] - corner;
    const Vector3d normal = parallelogram.geometricNormal(0);
    std::vector<TestRay> rays;
    for (int row = 0; row < columns; ++row) {
        for (int column = 0; column < columns; ++column) {
            const double s = 0.05 + 0.9 * (column + random.uniform()) / columns;
            const double t = 0.05 + 0.9 * (row + random.uniform()) / columns;
            const Vector3d target = corner + s * a + t * b;
            const Vector3d tilt = random.direction();
            const Vector3d origin = target + distance * (normal + 0.5 * tilt);
            // As floats: the renderer's ray is then exactly the one we compute with.
            TestRay ray;
            ray.origin = origin.cast<float>().cast<double>();
            ray.direction = (target - ray.origin).normalized().cast<float>().cast<double>();
            rays.push_back(ray);
        }
    }
    return rays;
}

Vector3d hitPoint(const TestRay &ray, const TestMesh &mesh, std::size_t face) {
    const Vector3d normal = mesh.geometricNormal(face);
    const Vector3d &on = mesh.positions[static_cast<std::size_t>(mesh.faces[face][0])];
    return ray.origin + ray.direction * ((on - ray.origin).dot(normal) / ray.direction.dot(normal));
}

CheckResult judgeRadiance(CheckContext &context, const RadianceCase &test) {
    return Judge(context, test).judge();
}

} // namespace grader
