// SPDX-License-Identifier: MIT
#include <battery/inputs.h>
#include <battery/nearest_mistake.h>
#include <catalog/warp_catalog.h>

#include <gtest/gtest.h>

#include "sample_warps.h"

namespace {

constexpr std::size_t kSamples = std::size_t{1} << 18U;

} // namespace

TEST(NearestMistake, NamesTheMistakeOfEveryWrongTwin) {
    const auto inputs = battery::randomInputs(kSamples, 5);
    for (const auto &sample : sample_warps::kWrong) {
        const double a = sample.warpId == "beckmann" ? 0.3 : 0.0;
        const auto match = battery::nearestMistake(catalog::requireWarp(sample.warpId), a,
                                                   sample_warps::run(sample, inputs, a));
        EXPECT_EQ(match.mistake == nullptr ? "" : match.mistake->id, sample.mistakeId)
            << sample.warpId << " " << sample.name << ": explained " << match.explained;
    }
}

TEST(NearestMistake, AccusesNoRightWarp) {
    const auto inputs = battery::randomInputs(kSamples, 6);
    for (const auto &sample : sample_warps::kRight) {
        const double a = sample.warpId == "beckmann" ? 0.3 : 0.0;
        const auto match = battery::nearestMistake(catalog::requireWarp(sample.warpId), a,
                                                   sample_warps::run(sample, inputs, a));
        EXPECT_EQ(match.mistake, nullptr) << sample.warpId << " " << sample.name;
    }
    EXPECT_EQ(battery::nearestMistake(catalog::requireWarp("disk"), 0.0, {}).mistake, nullptr);
}
