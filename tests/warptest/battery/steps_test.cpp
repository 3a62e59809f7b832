// SPDX-License-Identifier: MIT
#include <battery/inputs.h>
#include <battery/steps.h>
#include <catalog/warp_catalog.h>

#include <gtest/gtest.h>

#include <cmath>

#include "sample_warps.h"

namespace {

constexpr std::size_t kSamples = 65536;

battery::StepResult judge(const sample_warps::SampleWarp &sample,
                          const std::vector<battery::Input> &inputs, double a) {
    return battery::judgeSteps(catalog::requireWarp(sample.warpId), a,
                               sample_warps::run(sample, inputs, a));
}

} // namespace

// The probability of a false alarm is below 1e-20 per warp: see StepResult.
TEST(JudgeSteps, AcceptsEveryRightWarp) {
    for (const auto &sample : sample_warps::kRight) {
        for (const double a : catalog::requireWarp(sample.warpId).parameters) {
            for (std::uint64_t seed = 1; seed <= 3; ++seed) {
                const auto result = judge(sample, battery::randomInputs(kSamples, seed), a);
                EXPECT_FALSE(result.isStepped())
                    << sample.warpId << " " << sample.name << " a = " << a << ": "
                    << result.coordinate << " " << result.gap;
            }
        }
    }
}

TEST(JudgeSteps, FindsRoundedRandomNumbers) {
    for (const auto &sample : sample_warps::kRight) {
        const double a = catalog::requireWarp(sample.warpId).parameters.back();
        for (const float steps : {16.0F, 64.0F, 100.0F}) {
            auto inputs = battery::randomInputs(kSamples, 1);
            for (battery::Input &input : inputs) {
                input.u = (std::floor(input.u * steps) + 0.5F) / steps;
                input.v = (std::floor(input.v * steps) + 0.5F) / steps;
            }
            EXPECT_TRUE(judge(sample, inputs, a).isStepped())
                << sample.warpId << " " << sample.name << " " << steps;
            EXPECT_TRUE(judge(sample, inputs, a).isLined())
                << sample.warpId << " " << sample.name << " " << steps;
        }
    }
}

TEST(JudgeSteps, TakesAHoleForNoLines) {
    const auto &disk = catalog::requireWarp("disk");
    std::vector<battery::Output> outputs;
    for (const battery::Input &input : battery::randomInputs(kSamples, 1)) {
        const float x = 1.4F * input.u - 0.7F;
        if (std::abs(x) > 0.1F) {
            outputs.push_back({x, 1.4F * input.v - 0.7F, 0.0F});
        }
    }
    const battery::StepResult found = battery::judgeSteps(disk, 0.0, outputs);
    EXPECT_TRUE(found.isStepped());
    EXPECT_FALSE(found.isLined()) << found.emptied;
}

TEST(JudgeSteps, HasNothingToSayOfTooFewOutputs) {
    const auto &disk = catalog::requireWarp("disk");
    EXPECT_FALSE(battery::judgeSteps(disk, 0.0, {}).isStepped());
    const std::vector<battery::Output> few{{0.1F, 0.2F, 0.0F}, {0.3F, -0.2F, 0.0F}};
    EXPECT_FALSE(battery::judgeSteps(disk, 0.0, few).isStepped());
}
