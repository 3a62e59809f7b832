// SPDX-License-Identifier: MIT
#include <grader/error.h>
#include <grader/images/comparison.h>
#include <grader/images/tile_map.h>
#include <statistics/random.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace grader {
namespace {

constexpr int kSize = 48;
constexpr std::size_t kPixels = kSize * kSize;

/// What to change in a render.
struct Fault {
    double factor = 1;     ///< on all
    double tileFactor = 1; ///< on the tile at (16, 8)
    double smoothing = 1;  ///< of the deviation from the mean
};

/// As `nori --moments` writes it, of samples uniform in [0, 2 brightness].
protocol::Image render(std::uint64_t seed, int spp = 4096, const Fault &fault = {}) {
    statistics::Random random(seed);
    protocol::Image image{"exr", kSize, kSize, {}, {{"spp", std::to_string(spp)}}};
    image.channels.push_back({"count.Y", std::vector<float>(kPixels, static_cast<float>(spp))});
    for (const std::string name : {"R", "G", "B"}) {
        protocol::Channel mean{"mean." + name, {}};
        protocol::Channel variance{"variance." + name, {}};
        for (std::size_t i = 0; i < kPixels; ++i) {
            const bool inTile = i % kSize / 8 == 2 && i / kSize / 8 == 1;
            const double value = fault.factor * (inTile ? fault.tileFactor : 1);
            double noise = -6; // normal enough, variance 1
            for (int k = 0; k < 12; ++k)
                noise += random.nextDouble();
            const double deviation = value / std::sqrt(3.0);
            mean.values.push_back(static_cast<float>(value + fault.smoothing * noise * deviation /
                                                                 std::sqrt(double(spp))));
            variance.values.push_back(static_cast<float>(deviation * deviation));
        }
        image.channels.push_back({name, mean.values});
        image.channels.push_back(std::move(mean));
        image.channels.push_back(std::move(variance));
        image.channels.push_back({"third." + name, std::vector<float>(kPixels, 0.0F)});
    }
    return image;
}

protocol::Image withoutMoments(protocol::Image image) {
    std::erase_if(image.channels, [](const auto &channel) { return channel.name.size() > 1; });
    return image;
}

TEST(CompareImages, FindsIndependentRendersOfOneSceneAlike) {
    const Comparison one = compareImages(render(1), {render(2)});
    EXPECT_EQ(one.likeness, Likeness::Alike) << one.reasons.front();
    EXPECT_FALSE(one.scaleIsUnbiased);
    const Comparison two = compareImages(render(1), {render(2), render(3)});
    EXPECT_EQ(two.likeness, Likeness::Alike) << two.reasons.front();
    EXPECT_TRUE(two.scaleIsUnbiased);
    // 4.9 standard errors: a level of 1e-6
    EXPECT_LT(std::fabs(two.channels[0].scale->beta), 4.9 * two.channels[0].scale->standardError);
}

TEST(CompareImages, RarelyCallsRightRendersDifferent) {
    // At a level of 0.05, 200 runs give at most 10 expected (Bonferroni: fewer); 24 is 99.99 %.
    int different = 0;
    for (std::uint64_t run = 0; run < 200; ++run) {
        const Comparison found = compareImages(render(10 + 2 * run, 64), {render(11 + 2 * run, 64)},
                                               {.significance = 0.05});
        different += found.likeness == Likeness::Different ? 1 : 0;
    }
    EXPECT_LE(different, 24);
}

TEST(CompareImages, FindsAFactorAndSaysWhich) {
    // The mean's relative error is 1.4 / sqrt(3 * 2304 * 4096) = 0.03 %: 1 % is 33 deviations.
    const Comparison found = compareImages(render(1, 4096, {.factor = 1.01}), {render(2)});
    EXPECT_EQ(found.likeness, Likeness::Different);
    EXPECT_NEAR(found.channels[0].scale->beta, 0.01, 0.002);
    EXPECT_NEAR(found.channels[0].tiles->globalRelativeError, 0.01, 0.002);
}

TEST(CompareImages, FindsATile) {
    // A tile's relative error is 0.816 / sqrt(64 * 4096) = 0.16 %: 5 % is 31 deviations.
    const Comparison found = compareImages(render(1, 4096, {.tileFactor = 1.05}), {render(2)});
    EXPECT_EQ(found.likeness, Likeness::Different);
    const statistics::TileWelchResult &tiles = *found.channels[1].tiles;
    EXPECT_EQ(tiles.tiles[tiles.worstTile].x, 16);
    EXPECT_EQ(tiles.tiles[tiles.worstTile].y, 8);
    EXPECT_GT(tileMapPng(found).size(), 100U);
}

TEST(CompareImages, CannotTellFromTooFewSamples) {
    EXPECT_EQ(compareImages(render(1, 4), {render(2, 4)}).likeness, Likeness::CannotTell);
}

TEST(CompareImages, CannotTellRendersThatShareNoise) {
    const Comparison found =
        compareImages(render(1, 4096, {.smoothing = 0.3}), {render(2, 4096, {.smoothing = 0.3})});
    EXPECT_EQ(found.likeness, Likeness::CannotTell);
    EXPECT_NE(found.reasons.front().find("share samples"), std::string::npos)
        << found.reasons.front();
    // the very same image is another matter
    EXPECT_EQ(compareImages(render(1), {render(1)}).likeness, Likeness::Alike);
}

TEST(CompareImages, SaysWhatIsMissing) {
    const Comparison none = compareImages(withoutMoments(render(1)), {withoutMoments(render(2))});
    EXPECT_EQ(none.likeness, Likeness::CannotTell);
    EXPECT_NE(none.reasons.front().find("--moments"), std::string::npos);
    EXPECT_GT(none.channels[0].errors.rmse, 0);
    EXPECT_TRUE(none.flip);
    EXPECT_THROW(tileMapPng(none), GraderError);
    protocol::Image silent = withoutMoments(render(2));
    silent.attributes.clear();
    const Comparison unknown = compareImages(render(1), {silent});
    EXPECT_EQ(unknown.likeness, Likeness::CannotTell);
    EXPECT_NE(unknown.reasons.front().find("--reference-spp"), std::string::npos);
    EXPECT_TRUE(compareImages(render(1), {silent}, {.referenceCount = 16}).isFiltered);
    EXPECT_EQ(compareImages(render(1, 1), {render(2, 1)}).likeness, Likeness::CannotTell);
}

TEST(CompareImages, TellsANoisierReferenceFromAnotherScene) {
    const protocol::Image noisy = withoutMoments(render(2, 256));
    const auto compare = [&](const Fault &fault) {
        return compareImages(render(1, 4096, fault), {noisy}, {.referenceCount = 4096});
    };
    const Comparison found = compare({});
    EXPECT_EQ(found.likeness, Likeness::Different);
    // These pixels share no samples, unlike those of the film that is assumed: a fifth more noise.
    EXPECT_GT(found.apparentCount, 128);
    EXPECT_LT(found.apparentCount, 300);
    EXPECT_NE(found.reasons.back().find("noise alone"), std::string::npos) << found.reasons.back();
    const Comparison tile = compare({.tileFactor = 2});
    EXPECT_EQ(tile.reasons.back().find("noise alone"), std::string::npos) << tile.reasons.back();
}

TEST(CompareImages, CountsPixelsThatAreNotFinite) {
    protocol::Image broken = render(1);
    broken.channels[1].values[7] = std::numeric_limits<float>::quiet_NaN();
    const Comparison found = compareImages(broken, {render(2)});
    EXPECT_EQ(found.likeness, Likeness::Different);
    EXPECT_EQ(found.reasons.front(), "The image has 1 pixel that is not finite (NaN or infinite).");
    EXPECT_EQ(compareImages(render(1), {broken}).likeness, Likeness::CannotTell);
}

TEST(CompareImages, RefusesWhatCannotBeLaidOverEachOther) {
    protocol::Image small = render(1);
    small.height = kSize / 2;
    for (protocol::Channel &channel : small.channels)
        channel.values.resize(kPixels / 2);
    EXPECT_THROW(compareImages(small, {render(2)}), GraderError);
    protocol::Image grey = render(1);
    std::erase_if(grey.channels, [](const auto &channel) { return channel.name == "G"; });
    try {
        compareImages(render(1), {grey});
        FAIL();
    } catch (const GraderError &error) {
        EXPECT_NE(std::string(error.what()).find("The reference has no channel G"),
                  std::string::npos);
    }
}

} // namespace
} // namespace grader
