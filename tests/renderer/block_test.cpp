// SPDX-License-Identifier: MIT
#include <nori/bitmap.h>
#include <nori/block.h>
#include <nori/rfilter.h>

#include <gtest/gtest.h>

#include <set>

#include "fixtures.h"

namespace nori {
namespace {

TEST(ImageBlock, ReconstructsAConstantExactly) {
    const auto filter = test::make<ReconstructionFilter>("gaussian");
    ImageBlock block(Vector2i(8, 4), filter.get());
    block.setOffset(Point2i(0, 0));
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 8; ++x)
            block.put(Point2f(static_cast<float>(x) + 0.3f, static_cast<float>(y) + 0.9f),
                      Color3f(0.25f, 0.5f, 2.0f));
    }
    const std::unique_ptr<Bitmap> bitmap(block.toBitmap());
    for (Eigen::Index i = 0; i < bitmap->size(); ++i)
        EXPECT_LT((bitmap->data()[i] - Color3f(0.25f, 0.5f, 2.0f)).abs().maxCoeff(), 1e-5f);
}

TEST(ImageBlock, KeepsABoxFilteredSampleInItsPixel) {
    const auto filter = test::make<ReconstructionFilter>("box");
    ImageBlock block(Vector2i(3, 3), filter.get());
    block.put(Point2f(1.9f, 1.1f), Color3f(1.0f));
    EXPECT_EQ(block.getBorderSize(), 0);
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 3; ++x)
            EXPECT_EQ(block.coeff(y, x).w(), x == 1 && y == 1 ? 1.0f : 0.0f) << x << " " << y;
    }
}

TEST(ImageBlock, DropsSamplesThatAreNoRadianceWithTheirWeight) {
    const auto filter = test::make<ReconstructionFilter>("box");
    ImageBlock block(Vector2i(1, 1), filter.get());
    const Point2f center(0.5f, 0.5f);
    block.put(center, Color3f(4.0f));
    testing::internal::CaptureStderr();
    for (int i = 0; i < 100; ++i)
        block.put(center, Color3f(i % 2 == 0 ? NAN : -1.0f, 1.0f, 1.0f));
    const std::string messages = testing::internal::GetCapturedStderr();

    EXPECT_EQ(block.coeff(0, 0).w(), 1.0f);
    EXPECT_EQ(block.getInvalidSampleCount(), 100u);
    EXPECT_LT(std::count(messages.begin(), messages.end(), '\n'), 10) << messages;
}

TEST(ImageBlock, AddsUpBlocksAtTheirPlaces) {
    const auto filter = test::make<ReconstructionFilter>("tent");
    const Color3f value(1.0f, 2.0f, 3.0f);
    ImageBlock whole(Vector2i(8, 8), filter.get());
    ImageBlock merged(Vector2i(8, 8), filter.get());
    ImageBlock part(Vector2i(4, 4), filter.get());
    for (const Point2i &offset : {Point2i(0, 0), Point2i(4, 0), Point2i(0, 4), Point2i(4, 4)}) {
        const Point2f pos(static_cast<float>(offset.x()) + 3.7f,
                          static_cast<float>(offset.y()) + 0.2f);
        part.setOffset(offset);
        part.clear();
        part.put(pos, value);
        merged.put(part);
        whole.put(pos, value);
    }
    for (Eigen::Index i = 0; i < whole.size(); ++i)
        EXPECT_LT((whole.data()[i] - merged.data()[i]).abs().maxCoeff(), 1e-6f);
}

TEST(BlockGenerator, CoversTheImageOnceFromTheCentre) {
    BlockGenerator generator(Vector2i(100, 50), 32);
    ImageBlock block(Vector2i(32, 32), nullptr);
    EXPECT_EQ(generator.getBlockCount(), 8);
    std::set<std::pair<int, int>> pixels;
    int blocks = 0;
    while (generator.next(block)) {
        ++blocks;
        if (blocks == 1) {
            EXPECT_EQ(block.getOffset().x(), 64);
        }
        for (int y = 0; y < block.getSize().y(); ++y) {
            for (int x = 0; x < block.getSize().x(); ++x)
                EXPECT_TRUE(
                    pixels.emplace(block.getOffset().x() + x, block.getOffset().y() + y).second);
        }
    }
    EXPECT_EQ(blocks, 8);
    EXPECT_EQ(pixels.size(), 5000u);
}

} // namespace
} // namespace nori
