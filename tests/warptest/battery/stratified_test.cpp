// SPDX-License-Identifier: MIT
#include <battery/inputs.h>
#include <battery/stratified.h>
#include <catalog/warp_catalog.h>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "sample_warps.h"

namespace {

/// Largest moment relative to the threshold, with the grader's own number of inputs.
double excess(const sample_warps::SampleWarp &sample, double a) {
    static const auto inputs = battery::stratifiedInputs(battery::kStratifiedSide, 3);
    const auto result = battery::judgeStratified(catalog::requireWarp(sample.warpId), a,
                                                 sample_warps::run(sample, inputs, a));
    return result.maxMoment / result.threshold;
}

} // namespace

TEST(JudgeStratified, LeavesRightWarpsFarBelowTheThreshold) {
    for (const auto &sample : sample_warps::kRight) {
        const double a = sample.warpId == "beckmann" ? 0.1 : 0.0;
        EXPECT_LT(excess(sample, a), 0.5) << sample.warpId << " " << sample.name;
    }
}

TEST(JudgeStratified, ExcusesRoundingWhereAlphaIsSmall) {
    for (const auto &sample : sample_warps::kRight) {
        if (sample.warpId == "beckmann") {
            EXPECT_LT(excess(sample, 0.01), 1.0) << sample.name;
            EXPECT_LT(excess(sample, 0.03), 1.0) << sample.name;
        }
    }
}

TEST(JudgeStratified, FindsEveryWrongTwinTheSubtleOnesToo) {
    for (const auto &sample : sample_warps::kWrong) {
        // Outputs outside of the support are left out, and what is left may be right: those are
        // for judgeRange().
        if (sample.name != "unfolded" && sample.name != "whole_sphere") {
            const double a = sample.warpId == "beckmann" ? 0.3 : 0.0;
            EXPECT_GT(excess(sample, a), 1.0) << sample.warpId << " " << sample.name;
        }
    }
}

TEST(JudgeStratified, NeedsASquareOfOutputs) {
    const auto &disk = catalog::requireWarp("disk");
    EXPECT_THROW(battery::judgeStratified(disk, 0.0, {}), std::invalid_argument);
    EXPECT_THROW(battery::judgeStratified(disk, 0.0, std::vector<battery::Output>(3)),
                 std::invalid_argument);
    const std::vector<battery::Output> lost(4, battery::Output{NAN, 0.0F, 0.0F});
    EXPECT_TRUE(battery::judgeStratified(disk, 0.0, lost).exceeds());
}
