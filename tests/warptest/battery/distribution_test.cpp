// SPDX-License-Identifier: MIT
#include <battery/distribution.h>
#include <battery/inputs.h>
#include <catalog/warp_catalog.h>
#include <statistics/random.h>

#include <gtest/gtest.h>

#include <stdexcept>

#include "sample_warps.h"

using statistics::Decision;

namespace {

constexpr std::size_t kSamples = battery::kDistributionSamples;

statistics::LockResult lock(const sample_warps::SampleWarp &sample, double a) {
    const auto &entry = catalog::requireWarp(sample.warpId);
    return statistics::tripleLock(
        [&](const statistics::StageRequest &request) {
            const auto inputs =
                battery::randomInputs(kSamples * static_cast<std::size_t>(request.sampleFactor),
                                      statistics::deriveSeed(1, sample.name, request.index));
            return battery::asStage(
                battery::judgeDistribution(entry, a, sample_warps::run(sample, inputs, a)));
        },
        battery::distributionLock(entry, a));
}

std::string label(const sample_warps::SampleWarp &sample, double a) {
    return std::string(sample.warpId) + " " + std::string(sample.name) +
           " a = " + std::to_string(a);
}

} // namespace

TEST(JudgeDistribution, PassesRightWarpsOfEveryKind) {
    for (const auto &sample : sample_warps::kRight) {
        for (const double a : catalog::requireWarp(sample.warpId).parameters) {
            EXPECT_EQ(lock(sample, a).decision, Decision::Pass) << label(sample, a);
        }
    }
}

TEST(JudgeDistribution, FailsWrongTwins) {
    for (const auto &sample : sample_warps::kWrong) {
        if (!sample.mistakeId.empty()) {
            const double a = sample.warpId == "beckmann" ? 0.3 : 0.0;
            EXPECT_EQ(lock(sample, a).decision, Decision::Fail) << label(sample, a);
        }
    }
}

TEST(JudgeDistribution, CountsWhatIsOutOfTheDomainAndNeverClampsIt) {
    const auto &triangle = catalog::requireWarp("triangle");
    std::vector<battery::Output> outputs;
    for (const auto &input : battery::randomInputs(20000, 4)) {
        outputs.push_back({input.u, input.v, 0.0F}); // the unit square: half is outside
    }
    const auto result = battery::judgeDistribution(triangle, 0.0, outputs);
    EXPECT_NEAR(static_cast<double>(result.invalid), 10000.0, 500.0);
    EXPECT_LT(result.pValue, 1e-100);
    EXPECT_NEAR(result.worstRelative, -0.5, 0.2);
    EXPECT_EQ(result.counts.size(), 1024U);
}

TEST(JudgeDistribution, SaysWhatItCouldHaveFound) {
    const auto &disk = catalog::requireWarp("disk");
    const auto inputs = battery::randomInputs(kSamples, 8);
    const auto result = battery::judgeDistribution(
        disk, 0.0, sample_warps::run(sample_warps::kRight[2], inputs, 0.0));
    // sqrt(118 / 2^20) = 1.06 %, and a little more for the tolerance.
    EXPECT_NEAR(result.mde, 0.0112, 0.0005);
    EXPECT_LT(result.rmsBound, 0.02);
    EXPECT_THROW(battery::judgeDistribution(disk, 0.0, {}), std::invalid_argument);
}

TEST(JudgeDistribution, ToleratesCollapsedPolesAndReportsThem) {
    const auto &beckmann = catalog::requireWarp("beckmann");
    const auto inputs = battery::randomInputs(kSamples, 9);
    for (const auto &sample : sample_warps::kRight) {
        if (sample.name == "sine_from_cosine") {
            const auto result =
                battery::judgeDistribution(beckmann, 0.01, sample_warps::run(sample, inputs, 0.01));
            EXPECT_GT(result.poleAtoms, kSamples / 2000); // 0.18 % are known to collapse
            EXPECT_GT(result.pValue, 1e-4);
        }
    }
}
