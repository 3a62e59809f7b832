// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include <preview/coloring.h>
#include <renderer/fixtures.h>
#include <window/color_map.h>

namespace preview {
namespace {

nori::Bitmap makeImage(int columns, int rows, float value) {
    nori::Bitmap image(nori::Vector2i(columns, rows));
    image.setConstant(nori::Color3f(value));
    return image;
}

TEST(Coloring, ShowsTheBytesOfThePngFile) {
    nori::Bitmap image(nori::Vector2i(256, 1));
    for (int x = 0; x < 256; ++x)
        image.coeffRef(0, x) = nori::Color3f(static_cast<float>(x) / 128, 0.003f, 1e9f);
    const nori::test::TemporaryFolder folder;
    image.savePNG(folder.file("image"));
    const nori::LDRBitmap png(folder.file("image.png"));
    const std::vector<std::uint32_t> colors = colorize(image, nullptr, Look());
    for (int x = 0; x < 256; ++x) {
        const std::uint32_t color = colors[static_cast<size_t>(x)];
        for (int c = 0; c < 3; ++c)
            ASSERT_EQ((color >> (8 * c)) & 0xffU, png.coeff(0, x)[c]) << x << ' ' << c;
    }
}

TEST(Coloring, MultipliesByPowersOfTwo) {
    Look look;
    look.exposure = -3;
    EXPECT_EQ(colorize(makeImage(1, 1, 4), nullptr, look)[0],
              displayColor(nori::Color3f(0.5f), true));
}

TEST(Coloring, MarksFaultyPixelsOnDemand) {
    Look look;
    for (const float value : {-1.0f, NAN, INFINITY}) {
        look.markFaulty = true;
        EXPECT_EQ(colorize(makeImage(1, 1, value), nullptr, look)[0], window::kNotANumberColor);
        look.markFaulty = false;
        EXPECT_NE(colorize(makeImage(1, 1, value), nullptr, look)[0], window::kNotANumberColor);
    }
}

TEST(Coloring, SplitsBetweenImageAndReference) {
    const nori::Bitmap image = makeImage(4, 1, 0);
    const nori::Bitmap reference = makeImage(4, 1, 2);
    const std::uint32_t black = 0xff000000U;
    const std::uint32_t white = 0xffffffffU;
    Look look;
    look.view = View::Split;
    look.split = 0.25;
    EXPECT_EQ(colorize(image, &reference, look),
              (std::vector<std::uint32_t>{black, white, white, white}));
    look.split = 1;
    EXPECT_EQ(colorize(image, &reference, look), std::vector<std::uint32_t>(4, black));
    look.view = View::Reference;
    EXPECT_EQ(colorize(image, &reference, look), std::vector<std::uint32_t>(4, white));
    EXPECT_EQ(colorize(image, nullptr, look), std::vector<std::uint32_t>(4, black));
}

TEST(Coloring, ShowsDifferencesInTwoColors) {
    const nori::Bitmap reference = makeImage(1, 1, 0.99f);
    Look look;
    look.view = View::Difference;
    EXPECT_EQ(colorize(reference, &reference, look)[0], window::diverging(0));
    EXPECT_EQ(colorize(makeImage(1, 1, 100), &reference, look)[0], window::diverging(1));
    EXPECT_EQ(colorize(makeImage(1, 1, -100), &reference, look)[0], window::diverging(-1));
    EXPECT_EQ(colorize(makeImage(1, 1, NAN), &reference, look)[0], window::kNotANumberColor);
    look.exposure = 2; // the same colour for a fourth of the difference
    EXPECT_EQ(colorize(makeImage(1, 1, 0.99f + 0.25f), &reference, look)[0], window::diverging(1));
    EXPECT_NEAR(signedDifference(nori::Color3f(1.09f), nori::Color3f(0.99f)), 0.1, 1e-6);
}

TEST(Coloring, StretchesByTheNearestPixel) {
    nori::Bitmap image(nori::Vector2i(2, 1));
    image.coeffRef(0, 1) = nori::Color3f(1.0f);
    const nori::Bitmap large = resized(image, 2, 6);
    for (int x = 0; x < 6; ++x)
        EXPECT_EQ(large.coeff(1, x)[0], x < 3 ? 0.0f : 1.0f) << x;
    EXPECT_EQ(resized(large, 1, 2).coeff(0, 1)[0], 1.0f);
}

} // namespace
} // namespace preview
