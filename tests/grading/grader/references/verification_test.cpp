// SPDX-License-Identifier: MIT
#include <grader/error.h>
#include <grader/references/verification.h>
#include <statistics/moments.h>
#include <statistics/random.h>

#include <gtest/gtest.h>

#include <cmath>

namespace grader {
namespace {

constexpr int kSize = 32;
constexpr double kLevel = 1e-6;

/// Exponential samples around a gradient.
/// \param gain  of the mean
protocol::Image render(std::uint64_t seed, double gain, int samples = 256) {
    statistics::Random random(seed);
    protocol::Image image;
    image.format = "exr";
    image.width = image.height = kSize;
    std::map<std::string, std::vector<float>> planes;
    for (int i = 0; i < kSize * kSize; ++i) {
        const double mean = gain * (0.5 + i % kSize / 16.0);
        statistics::RunningMoments moments;
        for (int j = 0; j < samples; ++j)
            moments.add(-mean * std::log1p(-random.nextDouble()));
        const statistics::MomentSummary summary = moments.summary();
        planes["count.Y"].push_back(static_cast<float>(summary.count));
        for (const char *channel : {"R", "G", "B"}) {
            planes[std::string("mean.") + channel].push_back(static_cast<float>(summary.mean));
            planes[std::string("variance.") + channel].push_back(
                static_cast<float>(summary.variance));
            planes[std::string("third.") + channel].push_back(
                static_cast<float>(summary.thirdCentral));
        }
    }
    for (const auto &[name, values] : planes)
        image.channels.push_back({name, values});
    return image;
}

const std::array<protocol::Image, 2> &halves() {
    static const std::array<protocol::Image, 2> both = {render(1, 1.0), render(2, 1.0)};
    return both;
}

TEST(Verification, AgreesWithARenderOfTheSameMean) {
    const Agreement agreement = compareWithReference(render(3, 1.0), halves(), kLevel);
    EXPECT_TRUE(agreement.isTested);
    EXPECT_EQ(agreement.tileSize, 8);
    EXPECT_GT(agreement.pValue, kLevel);
    EXPECT_LT(std::abs(agreement.scale), agreement.scaleBound);
    EXPECT_LT(agreement.scaleBound, 0.02);
    EXPECT_GT(agreement.scaleMde, 0.0);
    EXPECT_EQ(accordOf(agreement, kLevel), Accord::TooNoisy) << "more than half a percent";
    EXPECT_EQ(accordOf(compareHalves(halves()), kLevel), Accord::Alike);
}

TEST(Verification, FindsARenderThatIsTooBright) {
    const Agreement agreement = compareWithReference(render(3, 1.05), halves(), kLevel);
    ASSERT_LT(agreement.scaleMde, 0.05); // so it is found with a power of 0.999
    EXPECT_LT(agreement.pValue, kLevel);
    EXPECT_EQ(accordOf(agreement, kLevel), Accord::Different);
    EXPECT_NEAR(agreement.scale, 0.05, 0.015);
    EXPECT_GT(agreement.scaleBound, 0.05);
    EXPECT_LT(compareHalves({render(1, 1.05), halves()[1]}).pValue, kLevel);
}

TEST(Verification, TakesLargerTilesWhereTheSkewAsksForThem) {
    // skewness 2 of 4 samples: 0.125 in a tile of 8 x 8, beyond the gate at 0.1
    const Agreement agreement = compareWithReference(render(3, 1.0, 4), halves(), kLevel);
    EXPECT_GT(agreement.tileSize, 8);
    EXPECT_TRUE(agreement.isTested);
}

TEST(Verification, RefusesImagesThatCannotBeCompared) {
    protocol::Image small = render(3, 1.0);
    small.height /= 2;
    for (protocol::Channel &channel : small.channels)
        channel.values.resize(channel.values.size() / 2);
    EXPECT_THROW(compareWithReference(small, halves(), kLevel), GraderError);
    EXPECT_THROW(compareHalves({small, halves()[0]}), GraderError);
    protocol::Image plain = render(3, 1.0);
    plain.channels.pop_back();
    EXPECT_THROW(compareWithReference(plain, halves(), kLevel), GraderError);
}

TEST(Verification, UsesOtherAlgorithmsThanTheScene) {
    SceneFile scene;
    scene.integrator = "direct_ems";
    EXPECT_EQ(independentAlgorithms(scene),
              (std::vector<std::string>{"direct_mats", "direct_mis"}));
    scene.hasPointLight = true;
    EXPECT_EQ(independentAlgorithms(scene).front(), "direct_whitted");
    scene.integrator = "direct_whitted";
    EXPECT_EQ(independentAlgorithms(scene).front(), "direct_ems");
}

} // namespace
} // namespace grader
