// SPDX-License-Identifier: MIT
#include <grader/figures/figure_test.h>
#include <statistics/random.h>

#include <gtest/gtest.h>

#include <cmath>

namespace grader {
namespace {

constexpr int kSamples = 8;

PatchPlan plan() {
    PatchPlan plan;
    plan.width = 96;
    plan.height = 72;
    plan.patches = spreadPatches(plan.width, plan.height, 48, 8, 1);
    return plan;
}

/// What is rendered: a gradient of skewed samples with edges.
struct Scene {
    double factor = 1;
    double slope = 0.02;
    int samples = kSamples;
};

PatchImage render(std::uint64_t seed, const Scene &scene = {}) {
    const PatchPlan patches = plan();
    const std::vector<float> points = filmPoints(patches, scene.samples, seed);
    statistics::Random random(seed + 1'000'000);
    std::vector<float> radiance;
    for (std::size_t i = 0; i < points.size(); i += 2) {
        const double x = double{points[i]};
        const double y = double{points[i + 1]};
        const double mean = scene.factor * (0.1 + scene.slope * x) * (y < 40 ? 0.2 : 0.4);
        for (int c = 0; c < 3; ++c)
            radiance.push_back(static_cast<float>(-mean * std::log(1 - random.nextDouble())));
    }
    return develop(patches, points, radiance, scene.samples);
}

FigurePatches against(const PatchImage &figure, std::uint64_t seed = 100) {
    FigurePatches patches;
    patches.figure = figure;
    for (std::size_t i = 0; i < 3; ++i)
        patches.own[i] = render(seed + i);
    return patches;
}

TEST(FigureTest, KeepsItsLevelWhenOneProgramRenderedAll) {
    // 150 runs: 2.5 of three tests' p below 1/180 are expected; above 12 has probability 1e-5. The
    // tests share their images, so the count is of runs.
    int below = 0;
    for (std::uint64_t run = 0; run < 150; ++run) {
        const FigureFindings found = examineFigure(against(render(10 * run), 10 * run + 1));
        below += std::min({found.meanP, found.moreNoiseP, found.lessNoiseP}) < 1.0 / 180 ? 1 : 0;
        EXPECT_GT(std::min({found.meanP, found.moreNoiseP, found.lessNoiseP}), kFigureLevel);
    }
    EXPECT_LE(below, 12);
}

TEST(FigureTest, KeepsItsLevelInTheLevelsOfAPng) {
    for (std::uint64_t run = 0; run < 30; ++run) {
        FigurePatches patches = against(render(10 * run), 10 * run + 1);
        patches.scale = PixelScale::Levels;
        const FigureFindings found = examineFigure(patches);
        EXPECT_GT(std::min({found.meanP, found.moreNoiseP, found.lessNoiseP}), kFigureLevel);
    }
}

TEST(FigureTest, FindsOtherBrightnessAndKeepsThePicture) {
    const FigureFindings found = examineFigure(against(render(1, {.factor = 1.25})));
    EXPECT_LT(found.meanP, kFigureLevel);
    EXPECT_NEAR(found.meanError, 0.25, 0.03);
    EXPECT_GT(found.correlation, 0.95);
    EXPECT_GT(found.smoothness, 2.5);
    // What is promised to be found: a difference of the printed size.
    const FigureFindings alike = examineFigure(against(render(1)));
    EXPECT_GT(alike.meanMde, 0);
    const FigureFindings promised =
        examineFigure(against(render(1, {.factor = 1 + 1.2 * alike.meanMde})));
    EXPECT_LT(promised.meanP, kFigureLevel);
}

TEST(FigureTest, FindsAnotherPicture) {
    const FigureFindings found = examineFigure(against(render(1, {.factor = 8, .slope = -0.001})));
    EXPECT_LT(found.meanP, kFigureLevel);
    EXPECT_LT(found.correlation, 0.95);
}

TEST(FigureTest, FindsMoreAndLessNoise) {
    const FigureFindings more = examineFigure(against(render(1, {.samples = kSamples / 4})));
    EXPECT_LT(more.moreNoiseP, kFigureLevel);
    EXPECT_NEAR(more.noiseRatio, 4, 1);
    EXPECT_LT(more.smoothness, 2.5);
    const FigureFindings less = examineFigure(against(render(1, {.samples = kSamples * 16})));
    EXPECT_LT(less.lessNoiseP, kFigureLevel);
    EXPECT_LT(less.noiseRatio, 0.2);
    EXPECT_LT(less.smoothness, 2);
}

TEST(FigureTest, FindsMoreNoiseOnlyWithFewerSamplesOfItsOwn) {
    FigurePatches patches = against(render(1, {.samples = kSamples * 16}));
    patches.equalSamples = false; // stated: 128 samples
    const FigureFindings right = examineFigure(patches);
    EXPECT_EQ(right.lessNoiseP, 1);
    EXPECT_GT(std::min(right.meanP, right.moreNoiseP), kFigureLevel);
    patches.figure = render(1, {.samples = kSamples / 4});
    EXPECT_LT(examineFigure(patches).moreNoiseP, kFigureLevel);
}

TEST(FigureTest, TellsSmoothingFromMoreSamples) {
    PatchImage smoothed = render(1);
    for (PatchPixels &pixels : smoothed) {
        for (std::size_t c = 0; c < 3; ++c) { // rows of 8: the gradient along them stays
            for (std::size_t column = 0; column < 8; ++column) {
                float sum = 0;
                for (std::size_t row = 0; row < 8; ++row)
                    sum += pixels[8 * row + column][c] / 8;
                for (std::size_t row = 0; row < 8; ++row)
                    pixels[8 * row + column][c] = sum;
            }
        }
    }
    const FigureFindings found = examineFigure(against(smoothed));
    EXPECT_LT(found.lessNoiseP, kFigureLevel);
    EXPECT_GT(found.smoothness, 2);
}

TEST(FigureTest, SaysNothingOfBlackImages) {
    FigurePatches black = against(render(1, {.factor = 0}));
    for (PatchImage &own : black.own)
        own = black.figure;
    const FigureFindings found = examineFigure(black);
    EXPECT_EQ(found.patches, 0U);
    EXPECT_EQ(found.meanP, 1);
    EXPECT_EQ(found.meanMde, 0);
}

TEST(FigureTest, RefusesImagesOfOtherPatches) {
    FigurePatches patches = against(render(1));
    patches.own[1].pop_back();
    EXPECT_THROW(examineFigure(patches), std::invalid_argument);
}

} // namespace
} // namespace grader
