// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include <preview/image_summary.h>

namespace preview {
namespace {

nori::Bitmap makeImage(int columns, int rows, float value) {
    nori::Bitmap image(nori::Vector2i(columns, rows));
    image.setConstant(nori::Color3f(value, 2 * value, 4 * value));
    return image;
}

TEST(ImageSummary, HoldsMeanAndExtremesOfTheFiniteValues) {
    nori::Bitmap image = makeImage(3, 1, 1);
    image.coeffRef(0, 1) = nori::Color3f(NAN, 8, INFINITY);
    const ImageSummary summary = summarize(image);
    EXPECT_EQ(summary.mean, (std::array<double, 3>{1, 4, 4}));
    EXPECT_EQ(summary.smallest, (std::array<double, 3>{1, 2, 4}));
    EXPECT_EQ(summary.largest, (std::array<double, 3>{1, 8, 4}));
}

TEST(ImageSummary, CountsFaultyPixelsAndListsTheFirst) {
    nori::Bitmap image = makeImage(20, 10, 1);
    image.coeffRef(2, 7)[1] = NAN;
    image.coeffRef(2, 7)[2] = -1;
    image.coeffRef(9, 19)[0] = -INFINITY;
    const ImageSummary summary = summarize(image);
    EXPECT_EQ(summary.notANumber, 1u);
    EXPECT_EQ(summary.infinite, 1u);
    EXPECT_EQ(summary.negative, 2u);
    ASSERT_EQ(summary.faulty.size(), 2u);
    EXPECT_EQ(summary.faulty[0], nori::Point2i(7, 2));
    EXPECT_EQ(summary.faulty[1], nori::Point2i(19, 9));

    EXPECT_EQ(summarize(makeImage(20, 10, -1)).faulty.size(), kListedPixels);
    EXPECT_EQ(summarize(makeImage(20, 10, -1)).negative, 200u);
}

TEST(ImageSummary, OfNothingIsZero) {
    EXPECT_EQ(summarize(nori::Bitmap()).mean, (std::array<double, 3>{}));
    EXPECT_EQ(summarize(makeImage(2, 2, NAN)).largest, (std::array<double, 3>{}));
}

TEST(ImageError, IsThatOfTheDefinitions) {
    nori::Bitmap image = makeImage(2, 1, 1); // 1, 2, 4
    const nori::Bitmap reference = image;
    image.coeffRef(0, 0) += nori::Color3f(0.5f);
    const ImageError error = measureError(image, reference).value();
    EXPECT_NEAR(error.rmse, std::sqrt(3 * 0.25 / 6), 1e-12);
    EXPECT_NEAR(error.relative, 0.25 * (1 / 1.01 + 1 / 4.01 + 1 / 16.01) / 6, 1e-12);
    EXPECT_NEAR(error.bias, 1.5 / 14, 1e-12);
}

TEST(ImageError, LeavesOutWhatIsNotFinite) {
    nori::Bitmap image = makeImage(2, 1, 1);
    const nori::Bitmap reference = image;
    image.coeffRef(0, 0) = nori::Color3f(NAN, INFINITY, 4);
    EXPECT_EQ(measureError(image, reference)->rmse, 0.0);
    EXPECT_EQ(measureError(makeImage(2, 1, NAN), reference)->rmse, 0.0);
}

TEST(ImageError, IsNotThereForOtherSizes) {
    EXPECT_FALSE(measureError(makeImage(2, 1, 1), makeImage(1, 2, 1)));
}

} // namespace
} // namespace preview
