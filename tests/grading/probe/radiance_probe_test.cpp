// SPDX-License-Identifier: MIT
#include <support/probe_child.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using protocol::Op;
using protocol::State;

constexpr char kProbe[] = NORI_PROBE_REFERENCE;
constexpr char kFaulty[] = NORI_PROBE_FAULTY;
constexpr float kAlbedo = 0.5F;
constexpr char kCeiling[] =
    R"(<mesh type="obj"><string name="filename" value="ceiling.obj"/>
       <bsdf type="diffuse"><color name="albedo" value="0.5,0.5,0.5"/></bsdf></mesh>)";
constexpr char kPointLight[] =
    R"(<emitter type="pointlight"><point name="position" value="0,0,0"/>
       <color name="radiance" value="8,4,2"/></emitter>)";
constexpr char kEnvironment[] =
    R"(<emitter type="environment"><color name="radiance" value="1,2,4"/></emitter>)";

/// Two rays that meet the ceiling from below, at its centre and at (0.5, 0, 2).
const std::vector<float> kRays = {0, 0, 1, 0, 0, 1, 0.5F, 0, 1, 0, 0, 1};

protocol::Request radianceRequest(std::vector<float> rays, std::uint32_t repeats,
                                  std::uint64_t seed) {
    protocol::Request request = test::sceneRequest(Op::Radiance, std::move(rays));
    request.repeats = repeats;
    request.seed = seed;
    return request;
}

std::vector<float> radianceOf(const std::string &objects, const protocol::Request &request) {
    return test::askOne(kProbe, test::sceneFile(kCeiling + objects, "direct_ems"), request,
                        {test::ceilingObj()});
}

TEST(RadianceProbe, GivesTheClosedFormUnderOnePointLight) {
    const std::vector<float> rows = radianceOf(kPointLight, radianceRequest(kRays, 2, 1));
    ASSERT_EQ(rows.size(), 12U);
    for (std::size_t i = 0; i < 12; ++i) {
        const double x = i < 6 ? 0 : 0.5;
        const double squared = x * x + 4;
        const double intensity = 8 / std::pow(2, i % 3);
        const double expected =
            double{kAlbedo} / M_PI * intensity / squared * 2 / std::sqrt(squared);
        EXPECT_NEAR(static_cast<double>(rows[i]), expected, 1e-4 * expected) << i;
    }
}

/// z of the mean of `count` values of every third row against albedo * L under a constant
/// environment: uniform sphere sampling has the variance (5/3) (albedo L)^2.
double zAgainst(const std::vector<float> &rows, std::size_t ray, std::size_t count,
                double expected) {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i)
        sum += static_cast<double>(rows[3 * (ray * count + i)]);
    const double error = expected * std::sqrt(5.0 / 3.0 / static_cast<double>(count));
    return (sum / static_cast<double>(count) - expected) / error;
}

TEST(RadianceProbe, AveragesToAlbedoTimesRadianceUnderAConstantEnvironment) {
    // Level 1e-6 for both rays together. The wrong twin is a quarter brighter: at 14 standard
    // errors, its power differs from 1 by less than 1e-15.
    constexpr std::uint32_t kCount = 8192;
    constexpr double kLimit = 5.03;
    const std::vector<float> rows = radianceOf(kEnvironment, radianceRequest(kRays, kCount, 2));
    for (const std::size_t ray : {std::size_t{0}, std::size_t{1}}) {
        EXPECT_LT(std::abs(zAgainst(rows, ray, kCount, double{kAlbedo})), kLimit);
        EXPECT_GT(std::abs(zAgainst(rows, ray, kCount, 1.25 * double{kAlbedo})), kLimit);
    }
}

TEST(RadianceProbe, RepeatsItselfForASeedAndRayAndForNothingElse) {
    const protocol::Request request = radianceRequest(kRays, 16, 3);
    const std::vector<float> rows = radianceOf(kEnvironment, request);
    EXPECT_EQ(rows, radianceOf(kEnvironment, request));
    // A ray's numbers depend on its place and the seed, not on the rays before it.
    std::vector<float> otherFirst = kRays;
    otherFirst[0] = 0.1F;
    const std::vector<float> other =
        radianceOf(kEnvironment, radianceRequest(std::move(otherFirst), 16, 3));
    EXPECT_TRUE(std::equal(rows.begin() + 48, rows.end(), other.begin() + 48));
    EXPECT_NE(rows, radianceOf(kEnvironment, radianceRequest(kRays, 16, 4)));
    // The two rays see the same on average, with numbers of their own.
    EXPECT_FALSE(std::equal(rows.begin(), rows.begin() + 48, rows.begin() + 48));
}

TEST(RadianceProbe, PreparesTheIntegratorOnce) {
    protocol::RequestGroup group;
    group.files = {test::sceneFile("", "counting")};
    group.requests.assign(2, radianceRequest({0, 0, 0, 0, 0, 1}, 1, 1));
    const test::ProbeRun run = test::runProbe(kFaulty, group);
    for (const protocol::Response &response : run.responses)
        EXPECT_EQ(response.values, (std::vector<float>{1, 1, 1}));
}

TEST(RadianceProbe, LetsNoOtherAnswerDependOnPreparing) {
    protocol::RequestGroup group;
    group.files = {test::sceneFile(kCeiling, "faulty_integrator"), test::ceilingObj()};
    const protocol::Request mesh = test::sceneRequest(Op::MeshDensity, {0, 0, 2});
    const protocol::Request radiance = radianceRequest({0, 0, 0, 0, 0, 1}, 1, 1);
    group.requests = {mesh, radiance, radiance, mesh};
    const test::ProbeRun run = test::runProbe(kFaulty, group);
    EXPECT_EQ(run.responses[0].state, State::Done);
    EXPECT_EQ(run.responses[1].message, "cannot prepare");
    EXPECT_EQ(run.responses[2].message, "cannot prepare");
    EXPECT_EQ(run.responses[3].state, State::Done);
}

} // namespace
