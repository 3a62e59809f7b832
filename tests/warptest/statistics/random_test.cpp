// SPDX-License-Identifier: MIT
#include <statistics/random.h>

#include <gtest/gtest.h>

#include <set>

using statistics::deriveSeed;
using statistics::Random;

TEST(Random, IsSplitMix64) {
    // The reference implementation (S. Vigna, splitmix64.c) with state 1234567.
    Random random(1234567);
    EXPECT_EQ(random.nextBits(), 6457827717110365317U);
    EXPECT_EQ(random.nextBits(), 3203168211198807973U);
    EXPECT_EQ(random.nextBits(), 9817491932198370423U);
}

TEST(Random, StaysInItsRanges) {
    Random random(1);
    double sum = 0.0;
    for (int i = 0; i < 10000; ++i) {
        const double x = random.nextDouble();
        const float y = random.nextFloat();
        EXPECT_TRUE(x >= 0.0 && x < 1.0 && y >= 0.0F && y < 1.0F);
        EXPECT_LT(random.nextBelow(7), 7U);
        sum += x + static_cast<double>(y);
    }
    EXPECT_NEAR(sum / 20000.0, 0.5, 5.0 * 0.2887 / 141.4); // five standard errors
}

TEST(DeriveSeed, DependsOnEveryPart) {
    std::set<std::uint64_t> seeds;
    for (std::uint64_t run = 0; run < 4; ++run) {
        for (const char *purpose : {"", "warp.disk", "warp.disl", "warp.sphere"}) {
            for (unsigned stage = 0; stage < 4; ++stage) {
                for (unsigned replicate = 0; replicate < 4; ++replicate) {
                    seeds.insert(deriveSeed(run, purpose, stage, replicate));
                }
            }
        }
    }
    EXPECT_EQ(seeds.size(), 256U);
    EXPECT_EQ(deriveSeed(1, "a", 2, 3), deriveSeed(1, "a", 2, 3));
}
