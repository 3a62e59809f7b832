// SPDX-License-Identifier: MIT
#include <grader/figures/plateau.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace grader {
namespace {

/// A ramp in three channels whose values above `most` are cut off.
protocol::Image ramp(float most) {
    protocol::Image image;
    image.width = 8;
    image.height = 4;
    for (const char *name : {"B", "G", "R"}) {
        protocol::Channel channel;
        channel.name = name;
        for (int i = 0; i < 32; ++i)
            channel.values.push_back(std::min(most, static_cast<float>(i)));
        image.channels.push_back(std::move(channel));
    }
    return image;
}

TEST(Plateau, IsWhereManyPixelsHoldTheLargestValue) {
    const Plateau plateau = findPlateau(ramp(20));
    EXPECT_EQ(plateau.value, 20);
    ASSERT_EQ(plateau.spots.size(), 36u); // 12 pixels in each channel
    for (const std::size_t spot : plateau.spots)
        EXPECT_GE(spot / 3, 20u);
}

TEST(Plateau, IsNotThePeakOfAnImage) {
    EXPECT_TRUE(findPlateau(ramp(100)).spots.empty());
    EXPECT_TRUE(findPlateau(ramp(30)).spots.empty()); // 6 values
}

TEST(Plateau, IsNotBlackAndNotInfinite) {
    EXPECT_TRUE(findPlateau(ramp(0)).spots.empty());
    protocol::Image image = ramp(20);
    image.channels[1].values[3] = std::numeric_limits<float>::infinity();
    image.channels[2].values[3] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(findPlateau(image).value, 20);
}

} // namespace
} // namespace grader
