// SPDX-License-Identifier: MIT
#include <battery/inputs.h>
#include <battery/scatter.h>
#include <catalog/warp_catalog.h>

#include <gtest/gtest.h>

#include <bit>
#include <random>
#include <stdexcept>

#include "sample_warps.h"

namespace battery {
namespace {

constexpr int kSide = 256;

/// Uniform on the disk, but by a rejection that the sample only seeds.
Output rejected(const Input &input) {
    std::minstd_rand engine(std::bit_cast<std::uint32_t>(input.u) * 31 +
                            std::bit_cast<std::uint32_t>(input.v));
    std::uniform_real_distribution<float> side(-1, 1);
    for (;;) {
        const Output point{side(engine), side(engine), 0};
        if (point.x * point.x + point.y * point.y <= 1)
            return point;
    }
}

TEST(Scatter, IsSmallForEveryRightWarp) {
    const std::vector<Input> inputs = stratifiedInputs(kSide, 1);
    for (const sample_warps::SampleWarp &warp : sample_warps::kRight) {
        for (const double a : catalog::findWarp(warp.warpId)->parameters)
            EXPECT_LT(neighbourDistance(sample_warps::run(warp, inputs, a), kSide), 0.1)
                << warp.warpId << " " << warp.name << " " << a;
    }
}

TEST(Scatter, IsLargeForARejectionThatTheSampleSeeds) {
    std::vector<Output> outputs;
    for (const Input &input : stratifiedInputs(kSide, 2))
        outputs.push_back(rejected(input));
    EXPECT_GT(neighbourDistance(outputs, kSide), 0.9);
}

TEST(Scatter, IsNoneOfOnePoint) {
    EXPECT_EQ(neighbourDistance(std::vector<Output>(16), 4), 0);
    EXPECT_THROW(neighbourDistance(std::vector<Output>(15), 4), std::invalid_argument);
}

} // namespace
} // namespace battery
