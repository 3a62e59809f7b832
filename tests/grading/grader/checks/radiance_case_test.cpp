// SPDX-License-Identifier: MIT
#include <grader/checks/radiance_case.h>

#include <gtest/gtest.h>

#include <limits>

#include "fake_context.h"

namespace grader {
namespace {

/// 256 rays whose radiance is a light chosen with probability 1/4: values 0 or 4 times the mean.
RadianceCase quarterChoice() {
    RadianceCase test;
    SceneRandom random(1);
    for (int i = 0; i < 256; ++i) {
        test.rays.push_back({Vector3d::Zero(), Vector3d::UnitZ()});
        test.expected.push_back(random.color(0.5, 2));
    }
    test.diagnoses.lightCount = 4;
    return test;
}

/// An estimator of that case, `scale` times too bright.
FakeContext::Answer estimator(const RadianceCase &test, double scale,
                              float planted = std::numeric_limits<float>::quiet_NaN(),
                              double plantedPart = 0) {
    return [=](const protocol::RequestGroup &group) {
        const protocol::Request &request = group.requests[0];
        SceneRandom random(request.seed);
        std::vector<float> values;
        for (const Vector3d &mean : test.expected) {
            for (std::uint32_t i = 0; i < request.repeats; ++i) {
                const double factor = random.uniform() < 0.25 ? 4 * scale : 0;
                const bool plant = random.uniform() < plantedPart;
                for (int c = 0; c < 3; ++c)
                    values.push_back(plant ? planted : static_cast<float>(factor * mean[c]));
            }
        }
        return answerWith(std::move(values));
    };
}

// 524,288 samples of relative deviation sqrt(3): one standard error is 0.24 %, and a factor that is
// 2 % off is found with power above 0.999 at the level of the first stage, 1e-4.

TEST(JudgeRadiance, PassesAnUnbiasedEstimator) {
    const RadianceCase test = quarterChoice();
    FakeContext context(estimator(test, 1));
    const CheckResult result = judgeRadiance(context, test);
    EXPECT_EQ(result.verdict, Verdict::Pass) << result.message;
    EXPECT_LE(context.asked, 7) << "one stage";
}

TEST(JudgeRadiance, FailsOneThatIsTwoPercentOff) {
    const RadianceCase test = quarterChoice();
    FakeContext context(estimator(test, 1.02));
    const CheckResult result = judgeRadiance(context, test);
    EXPECT_EQ(result.verdict, Verdict::Fail) << result.message;
    EXPECT_NEAR(result.effect, 0.02, 0.01);
    EXPECT_GE(context.asked, 3) << "three stages have to agree";
}

TEST(JudgeRadiance, NamesAForgottenPickProbability) {
    const RadianceCase test = quarterChoice();
    FakeContext context(estimator(test, 0.25));
    const CheckResult result = judgeRadiance(context, test);
    EXPECT_EQ(result.verdict, Verdict::Fail);
    EXPECT_EQ(result.diagnoses.at(0).id, "ems.pick_pdf_forgotten");
    EXPECT_EQ(context.asked, 3) << "three stages of one look each";
}

TEST(JudgeRadiance, FailsInvalidSamplesOnlyAboveWhatTheFilmDrops) {
    const RadianceCase test = quarterChoice();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    FakeContext often(estimator(test, 1, nan, 0.01));
    EXPECT_EQ(judgeRadiance(often, test).verdict, Verdict::Fail);
    FakeContext seldom(estimator(test, 1, nan, 1e-5));
    EXPECT_EQ(judgeRadiance(seldom, test).verdict, Verdict::Pass);
}

TEST(JudgeRadiance, IgnoresRoundingWhereThereIsNoNoise) {
    RadianceCase test = quarterChoice();
    test.repeats = 16;
    const auto constant = [&](double factor) {
        return [&test, factor](const protocol::RequestGroup &group) {
            std::vector<float> values;
            for (const Vector3d &mean : test.expected) {
                for (std::uint32_t i = 0; i < 3 * group.requests[0].repeats; ++i)
                    values.push_back(static_cast<float>(factor * mean[i % 3]));
            }
            return answerWith(std::move(values));
        };
    };
    FakeContext rounded(constant(1 + 1e-6));
    EXPECT_EQ(judgeRadiance(rounded, test).verdict, Verdict::Pass);
    FakeContext wrong(constant(1.01));
    EXPECT_EQ(judgeRadiance(wrong, test).verdict, Verdict::Fail);
}

TEST(JudgeRadiance, JudgesSlowCodeOnFewerSamples) {
    const RadianceCase test = quarterChoice();
    const FakeContext::Answer fast = estimator(test, 1);
    FakeContext context([&](const protocol::RequestGroup &group) {
        if (group.requests[0].repeats < 512)
            return fast(group);
        ProbeAnswer late;
        late.outcome.end = BoxTimedOut{true};
        late.responses.resize(1);
        return late;
    });
    const CheckResult result = judgeRadiance(context, test);
    EXPECT_NE(result.verdict, Verdict::Timeout);
    EXPECT_NE(result.verdict, Verdict::Fail) << "slow is not wrong";
}

/// 32 x 32 pixels of mean 1 with samples 0 or 4, like quarterChoice(); `hole`: one pixel is black.
FakeContext::Answer pixels(int hole) {
    return [=](const protocol::RequestGroup &group) {
        ProbeAnswer answer = answerWith({});
        answer.responses.clear();
        for (const protocol::Request &request : group.requests) {
            SceneRandom random(request.seed);
            std::vector<float> values;
            for (const float pixel : request.values) {
                for (std::uint32_t i = 0; i < request.repeats; ++i) {
                    const bool lit = random.uniform() < 0.25 && pixel != static_cast<float>(hole);
                    values.insert(values.end(), 3, lit ? 4.0F : 0.0F);
                }
            }
            answer.responses.push_back({protocol::State::Done, "", 0, std::move(values)});
        }
        return answer;
    };
}

RadianceCase imageCase() {
    RadianceCase test;
    test.columns = 32;
    test.pixelRows = 32;
    test.repeats = 256;
    test.tilePassBound = 0.15;
    return test;
}

TEST(JudgeRadiance, ComparesPixelsWithOurOwn) {
    FakeContext context(pixels(-1), pixels(-1));
    // FakeContext gives both sides other seeds.
    const CheckResult result = judgeRadiance(context, imageCase());
    EXPECT_EQ(result.verdict, Verdict::Pass) << result.message;
    EXPECT_NE(result.message.find("1024 pixels"), std::string::npos) << result.message;
}

// A black pixel of 1024 is 0.1 % of the image: z = 9 in its own 256 samples, and nothing in its
// tile.
TEST(JudgeRadiance, FindsOnePixelThatIsBlack) {
    FakeContext context(pixels(77), pixels(-1));
    const CheckResult result = judgeRadiance(context, imageCase());
    EXPECT_EQ(result.verdict, Verdict::Fail) << result.message;
    EXPECT_NEAR(result.effect, 1 / 1024.0, 1e-4);
    EXPECT_EQ(result.diagnoses.at(0).id, "ems.part_of_image");
}

TEST(JudgeRadiance, TellsOfFireflies) {
    const RadianceCase test = quarterChoice();
    FakeContext context(estimator(test, 1, 1e7F, 1e-5));
    const CheckResult result = judgeRadiance(context, test);
    EXPECT_NE(result.message.find("firefly"), std::string::npos) << result.message;
}

TEST(JudgeRadiance, PassesOnWhatEndedTheProgram) {
    const RadianceCase test = quarterChoice();
    FakeContext context([](const protocol::RequestGroup &) {
        ProbeAnswer crashed;
        crashed.outcome.end = BoxSignalled{11};
        crashed.responses.resize(1);
        return crashed;
    });
    EXPECT_EQ(judgeRadiance(context, test).verdict, Verdict::Crash);
}

} // namespace
} // namespace grader
