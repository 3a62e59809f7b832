// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <numeric>

#include <preview/pass_schedule.h>

namespace preview {
namespace {

TEST(PassSchedule, GivesSmallImagesNoPass) {
    for (const int samples : {1, 2, 3})
        EXPECT_TRUE(passSchedule(samples).empty()) << samples;
    EXPECT_EQ(passSchedule(4), std::vector<int>{1});
}

TEST(PassSchedule, DoublesAfterTwoSinglePasses) {
    EXPECT_EQ(passSchedule(32), (std::vector<int>{1, 1}));
    EXPECT_EQ(passSchedule(512), (std::vector<int>{1, 1, 2, 4, 8, 16}));
}

TEST(PassSchedule, CostsASixteenthAtMost) {
    for (const int samples : {16, 31, 100, 1000, 1 << 24}) {
        const std::vector<int> passes = passSchedule(samples);
        EXPECT_LE(std::accumulate(passes.begin(), passes.end(), 0), samples / 16) << samples;
        EXPECT_GT(2 * std::accumulate(passes.begin(), passes.end(), 0), samples / 16) << samples;
    }
}

} // namespace
} // namespace preview
