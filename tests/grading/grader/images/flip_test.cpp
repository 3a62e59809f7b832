// SPDX-License-Identifier: MIT
#include <grader/images/flip.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace grader {
namespace {

protocol::Image image(int width, int height, float r, float g, float b) {
    const auto pixels = static_cast<std::size_t>(width * height);
    return {"exr",
            width,
            height,
            {{"B", std::vector<float>(pixels, b)},
             {"G", std::vector<float>(pixels, g)},
             {"R", std::vector<float>(pixels, r)}},
            {}};
}

TEST(Flip, IsZeroForEqualImages) {
    const protocol::Image grey = image(9, 5, 0.2F, 0.2F, 0.2F);
    for (const float value : flip(grey, grey))
        EXPECT_EQ(value, 0.0F);
}

TEST(Flip, OfBlackAndWhiteIsWhatThePaperGives) {
    // Uniform images: filters change nothing. The difference in L* is 100, and the largest one of
    // the paper (green against blue) is 203 before the exponent 0.7.
    const double largest = std::pow(203.0, 0.7);
    const double knee = 0.4 * largest;
    const double expected = 0.95 + (std::pow(100.0, 0.7) - knee) / (largest - knee) * 0.05;
    for (const float value : flip(image(8, 8, 0, 0, 0), image(8, 8, 1, 1, 1)))
        EXPECT_NEAR(double{value}, expected, 1e-3);
}

TEST(Flip, OfGreenAndBlueIsTheLargestThereIs) {
    for (const float value : flip(image(4, 4, 0, 1, 0), image(4, 4, 0, 0, 1)))
        EXPECT_NEAR(double{value}, 1, 1e-6);
}

TEST(Flip, ForgivesASpeckMoreThanAPatchAndSeesWhereItIs) {
    const protocol::Image grey = image(64, 64, 0.5F, 0.5F, 0.5F);
    protocol::Image speck = grey;
    protocol::Image patch = grey;
    for (protocol::Channel &channel : speck.channels)
        channel.values[32 * 64 + 32] = 0.8F;
    for (protocol::Channel &channel : patch.channels) {
        for (std::size_t y = 24; y < 40; ++y)
            std::fill_n(channel.values.begin() + static_cast<std::ptrdiff_t>(y * 64 + 24), 16,
                        0.8F);
    }
    const std::vector<float> ofSpeck = flip(speck, grey);
    const std::vector<float> ofPatch = flip(patch, grey);
    EXPECT_GT(ofSpeck[32 * 64 + 32], ofSpeck[0]);
    EXPECT_LT(ofSpeck[0], 1e-6F);
    EXPECT_GT(ofPatch[32 * 64 + 32], ofSpeck[32 * 64 + 32]);
}

TEST(Flip, SeesWhatAPngShows) {
    // Both are white in the PNG.
    for (const float value : flip(image(4, 4, 1, 1, 1), image(4, 4, 40, 40, 40)))
        EXPECT_EQ(value, 0.0F);
}

} // namespace
} // namespace grader
