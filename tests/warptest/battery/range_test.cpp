// SPDX-License-Identifier: MIT
#include <battery/inputs.h>
#include <battery/range.h>
#include <catalog/warp_catalog.h>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "sample_warps.h"

using battery::Output;

namespace {

battery::RangeResult judge(const sample_warps::SampleWarp &sample,
                           const std::vector<battery::Input> &inputs, double a) {
    return battery::judgeRange(catalog::requireWarp(sample.warpId), inputs,
                               sample_warps::run(sample, inputs, a));
}

} // namespace

TEST(JudgeRange, AcceptsRightWarpsAtEveryEdge) {
    for (const auto &sample : sample_warps::kRight) {
        for (const double a : catalog::requireWarp(sample.warpId).parameters) {
            const auto edges = judge(sample, battery::edgeInputs(), a);
            EXPECT_EQ(edges.bad(), 0U) << sample.warpId << " " << sample.name << " a = " << a;
            EXPECT_EQ(edges.total, 144U);
            EXPECT_EQ(judge(sample, battery::gridInputs(128), a).bad(), 0U) << sample.name;
        }
    }
}

TEST(JudgeRange, FindsOutputsOutsideOfTheDomain) {
    const auto inputs = battery::randomInputs(1000, 1);
    for (const auto &sample : sample_warps::kWrong) {
        if (sample.name == "unfolded" || sample.name == "whole_sphere" ||
            sample.name == "around_y") {
            EXPECT_NEAR(judge(sample, inputs, 0.0).badFraction(), 0.5, 0.1) << sample.name;
        }
    }
}

TEST(JudgeRange, TellsKindsApart) {
    const auto &hemisphere = catalog::requireWarp("hemisphere");
    const std::vector<battery::Input> inputs{
        {0.1F, 0.1F}, {0.1F, 0.1F}, {0.1F, 0.1F}, {0.1F, 0.1F}, {1.0F, 0.1F}};
    const std::vector<Output> outputs{{0.0F, 0.0F, 1.0F},
                                      {0.0F, 0.0F, -1.0F},
                                      {0.0F, 0.0F, 1.5F},
                                      {NAN, 0.0F, 1.0F},
                                      {NAN, 0.0F, 1.0F}};
    const auto result = battery::judgeRange(hemisphere, inputs, outputs);
    EXPECT_EQ(result.total, 4U);
    EXPECT_EQ(result.outside, 1U);
    EXPECT_EQ(result.offNorm, 1U);
    EXPECT_EQ(result.notFinite, 1U);
    EXPECT_EQ(result.firstBad, 1U);
    EXPECT_EQ(result.badBeyondContract, 1U);
    EXPECT_DOUBLE_EQ(result.worstDistance, 1.0);
    EXPECT_THROW(battery::judgeRange(hemisphere, inputs, {}), std::invalid_argument);
}
