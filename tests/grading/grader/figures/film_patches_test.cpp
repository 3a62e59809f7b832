// SPDX-License-Identifier: MIT
#include <grader/figures/film_patches.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace grader {
namespace {

TEST(SpreadPatches, CoverAnImageWithoutSharingSamples) {
    const std::vector<Patch> patches = spreadPatches(800, 600, 48, 8, 7);
    EXPECT_EQ(patches.size(), 48U);
    for (std::size_t i = 0; i < patches.size(); ++i) {
        const Patch &a = patches[i];
        EXPECT_EQ(a.width, 8);
        EXPECT_TRUE(a.x >= 0 && a.y >= 0 && a.x + 8 <= 800 && a.y + 8 <= 600);
        for (std::size_t j = 0; j < i; ++j) {
            const Patch &b = patches[j];
            EXPECT_TRUE(std::abs(a.x - b.x) >= 12 || std::abs(a.y - b.y) >= 12);
        }
    }
    const auto again = spreadPatches(800, 600, 48, 8, 8);
    EXPECT_NE(again[5].x * 1000 + again[5].y, patches[5].x * 1000 + patches[5].y);
}

TEST(SpreadPatches, AreFewerOrSmallerInSmallImages) {
    for (const auto &[width, height] : {std::pair(96, 72), {20, 20}, {200, 3}, {1, 1}, {7, 500}}) {
        const std::vector<Patch> patches = spreadPatches(width, height, 48, 8, 1);
        EXPECT_FALSE(patches.empty());
        EXPECT_LE(patches.size(), 60U);
        for (const Patch &patch : patches) {
            EXPECT_GE(patch.width, 1);
            EXPECT_TRUE(patch.x + patch.width <= width && patch.y + patch.height <= height)
                << width << " x " << height;
        }
    }
}

TEST(Develop, PutsSamplesThroughTheFilm) {
    PatchPlan plan;
    plan.width = 20;
    plan.height = 10;
    plan.patches = {{0, 0, 3, 2}, {10, 4, 1, 1}};
    const std::vector<float> points = filmPoints(plan, 64, 3);
    // Samples of the first patch come from 5 x 4 pixels (an edge on two sides), of the other 25.
    ASSERT_EQ(points.size(), 2U * 64 * (20 + 25));
    std::vector<float> radiance;
    for (std::size_t i = 0; i < points.size(); i += 2) {
        radiance.push_back(2);
        radiance.push_back(points[i]); // a gradient stays one away from the edges
        radiance.push_back(i % 4 == 0 ? std::numeric_limits<float>::quiet_NaN() : 1.0F);
    }
    const PatchImage image = develop(plan, points, radiance, 64);
    ASSERT_EQ(image.size(), 2U);
    ASSERT_EQ(image[0].size(), 6U);
    EXPECT_FLOAT_EQ(image[1][0][0], 2);
    EXPECT_NEAR(image[1][0][1], 10.5F, 0.15);
    EXPECT_FLOAT_EQ(image[1][0][2], 1); // what is no number is dropped, weight and all
}

TEST(Develop, LeavesBlackWhatNothingFallsOn) {
    PatchPlan plan;
    plan.width = plan.height = 9;
    plan.patches = {{4, 4, 1, 1}};
    const std::vector<float> points = filmPoints(plan, 1, 3);
    const std::vector<float> radiance(points.size() / 2 * 3, -1.0F);
    EXPECT_EQ(develop(plan, points, radiance, 1)[0][0], (std::array<float, 3>{0, 0, 0}));
}

TEST(CutOut, TakesThePixelsOfAPatch) {
    PatchPlan plan;
    plan.width = 3;
    plan.height = 2;
    plan.patches = {{1, 0, 2, 2}};
    const protocol::Image image{
        "exr",
        3,
        2,
        {{"B", {0, 0, 0, 0, 0, 9}}, {"G", {0, 0, 0, 0, 0, 0}}, {"R", {1, 2, 3, 4, 5, 6}}},
        {}};
    const PatchPixels pixels = cutOut(plan, image)[0];
    ASSERT_EQ(pixels.size(), 4U);
    EXPECT_EQ(pixels[0][0], 2);
    EXPECT_EQ(pixels[3], (std::array<float, 3>{6, 0, 9}));
}

} // namespace
} // namespace grader
