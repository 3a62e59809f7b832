// SPDX-License-Identifier: MIT
#include <battery/consistency.h>
#include <battery/inputs.h>
#include <catalog/warp_catalog.h>

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "sample_densities.h"
#include "sample_warps.h"

namespace {

template <typename Samples>
const auto &find(const Samples &samples, std::string_view warpId, std::string_view name) {
    for (const auto &sample : samples) {
        if (sample.warpId == warpId && sample.name == name) {
            return sample;
        }
    }
    throw std::invalid_argument("no such sample");
}

battery::ConsistencyResult judge(const sample_warps::SampleWarp &warp,
                                 const sample_densities::SampleDensity &density, double a) {
    const auto &entry = catalog::requireWarp(warp.warpId);
    const auto inputs = battery::randomInputs(std::size_t{1} << 18U, 4);
    const auto points = battery::consistencyPoints(entry, a);
    return battery::judgeConsistency(entry, a, sample_warps::run(warp, inputs, a),
                                     sample_densities::run(density, points, a));
}

} // namespace

TEST(JudgeNormalisation, FindsOneForRightDensitiesHoweverNarrow) {
    for (const auto &sample : sample_densities::kRight) {
        const auto &entry = catalog::requireWarp(sample.warpId);
        for (const double a : entry.parameters) {
            const auto points = battery::normalisationPoints(entry, a);
            const auto result =
                battery::judgeNormalisation(entry, a, sample_densities::run(sample, points, a));
            EXPECT_NEAR(result.value, 1.0, 1e-3) << sample.warpId << " " << sample.name << " " << a;
        }
    }
}

TEST(JudgeNormalisation, FindsTheFactorOfWrongOnes) {
    const auto &disk = catalog::requireWarp("disk");
    const std::vector<float> ones(battery::normalisationPoints(disk, 0.0).size(), 1.0F);
    EXPECT_NEAR(battery::judgeNormalisation(disk, 0.0, ones).value, 3.14159, 1e-4);
    EXPECT_THROW(battery::judgeNormalisation(disk, 0.0, std::vector<float>(3)),
                 std::invalid_argument);
}

TEST(JudgeConsistency, AcceptsRightPairs) {
    using sample_densities::kRight;
    for (const auto &warp : sample_warps::kRight) {
        for (const double a : catalog::requireWarp(warp.warpId).parameters) {
            for (const auto &density : kRight) {
                if (density.warpId == warp.warpId && warp.name != "sine_from_cosine") {
                    const auto result = judge(warp, density, a);
                    EXPECT_TRUE(result.consistent())
                        << warp.warpId << " " << warp.name << " " << density.name << " " << a
                        << " p = " << result.pValue;
                }
            }
        }
    }
}

TEST(JudgeConsistency, AcceptsAWrongPairThatBelongsTogether) {
    // Cosine-weighted where uniform was asked for: the case the assignment warns about.
    const auto result = judge(find(sample_warps::kWrong, "hemisphere", "cosine"),
                              find(sample_densities::kWrong, "hemisphere", "cosine"), 0.0);
    EXPECT_TRUE(result.consistent()) << "p = " << result.pValue;
    EXPECT_NEAR(result.insideMass, 1.0, 1e-3);
}

TEST(JudgeConsistency, AcceptsAWrongPairThatReachesBeyondTheSupport) {
    const sample_densities::SampleDensity sphere{"hemisphere", "sphere",
                                                 [](const battery::Output &, float) {
                                                     return 0.25F * sample_densities::kInvPi;
                                                 }};
    const auto result =
        judge(find(sample_warps::kWrong, "hemisphere", "whole_sphere"), sphere, 0.0);
    EXPECT_TRUE(result.consistent()) << "p = " << result.pValue;
    EXPECT_NEAR(result.insideMass, 0.5, 1e-3);
    EXPECT_NEAR(result.insideSamples, 0.5, 0.01);
}

TEST(JudgeConsistency, RejectsPairsThatDoNotBelongTogether) {
    const auto &polar = find(sample_warps::kRight, "disk", "polar");
    const auto &right = find(sample_densities::kRight, "disk", "squared_norm");
    EXPECT_FALSE(judge(polar, find(sample_densities::kWrong, "disk", "one"), 0.0).consistent());
    EXPECT_FALSE(
        judge(find(sample_warps::kWrong, "disk", "missing_root"), right, 0.0).consistent());
    const sample_densities::SampleDensity zero{"disk", "zero", [](const battery::Output &, float) {
                                                   return 0.0F;
                                               }};
    EXPECT_FALSE(judge(polar, zero, 0.0).consistent());
}
