// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include <preview/view_model.h>
#include <renderer/fixtures.h>

namespace preview {
namespace {

/// Pixel (x, y) is (x, y, 1).
nori::Bitmap makeImage(int columns, int rows) {
    nori::Bitmap image(nori::Vector2i(columns, rows));
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x)
            image.coeffRef(y, x) =
                nori::Color3f(static_cast<float>(x), static_cast<float>(y), 1.0f);
    }
    return image;
}

ViewModel makeModel(int columns = 40, int rows = 20) {
    ViewModel model("image.exr", nullptr);
    model.setArea(400, 400);
    model.setImage(makeImage(columns, rows));
    return model;
}

TEST(ViewModel, FitsTheImageIntoTheArea) {
    ViewModel model = makeModel();
    EXPECT_EQ(model.zoom(), 10.0);
    EXPECT_EQ(model.toArea(0, 0), (std::array<double, 2>{0, 100}));
    EXPECT_EQ(model.toArea(40, 20), (std::array<double, 2>{400, 300}));
    model.setArea(200, 400); // follows the window
    EXPECT_EQ(model.zoom(), 5.0);
    EXPECT_EQ(model.toImage(200, 250), (std::array<double, 2>{40, 20}));
}

TEST(ViewModel, ZoomsAboutThePointUnderThePointer) {
    ViewModel model = makeModel();
    const std::array<double, 2> before = model.toImage(130, 170);
    model.zoomBy(3, 130, 170);
    EXPECT_EQ(model.zoom(), 30.0);
    EXPECT_NEAR(model.toImage(130, 170)[0], before[0], 1e-9);
    EXPECT_NEAR(model.toImage(130, 170)[1], before[1], 1e-9);
    model.setArea(300, 300); // no longer fitted
    EXPECT_EQ(model.zoom(), 30.0);
    model.zoomBy(1e9, 0, 0);
    EXPECT_EQ(model.zoom(), 128.0);
    model.zoomBy(1e-9, 0, 0);
    EXPECT_EQ(model.zoom(), 1.0 / 16);
    model.fit();
    EXPECT_EQ(model.zoom(), 7.5);
}

TEST(ViewModel, NeverLosesTheImageWhenItIsMoved) {
    ViewModel model = makeModel();
    model.panBy(20, 0);
    EXPECT_EQ(model.toArea(0, 0)[0], 20.0);
    model.panBy(1e9, -1e9);
    EXPECT_EQ(model.toArea(0, 20), (std::array<double, 2>{200, 200}));
}

TEST(ViewModel, KnowsThePixelUnderThePointer) {
    ViewModel model = makeModel();
    model.pointAt(399, 299);
    ASSERT_TRUE(model.cursor());
    EXPECT_EQ(*model.cursor(), nori::Point2i(39, 19));
    EXPECT_EQ(model.pixelText(), "(39, 19) = (39, 19, 1)");
    EXPECT_EQ(model.pixelLines()[1], "image  39  19  1");
    model.pointAt(399, 301);
    EXPECT_FALSE(model.cursor());
    EXPECT_EQ(model.pixelText(), "");
}

TEST(ViewModel, WalksOverPixelsAndScrollsAfter) {
    ViewModel model = makeModel();
    model.moveCursor(1, -1); // from the middle
    EXPECT_EQ(*model.cursor(), nori::Point2i(21, 9));
    model.moveCursor(-1000, 1000);
    EXPECT_EQ(*model.cursor(), nori::Point2i(0, 19));
    model.zoomBy(12, 0, 0);
    model.moveCursor(39, 0);
    const std::array<double, 2> at = model.toArea(39.5, 19.5);
    EXPECT_GT(at[0], 0);
    EXPECT_LT(at[0], 400);
    EXPECT_GT(at[1], 0);
    EXPECT_LT(at[1], 400);
}

TEST(ViewModel, FindsFaultyPixelsOneAfterTheOther) {
    nori::Bitmap image = makeImage(10, 10);
    image.coeffRef(3, 4)[0] = NAN;
    image.coeffRef(8, 1)[2] = -1;
    ViewModel model("image.exr", nullptr);
    model.setImage(image);
    for (const nori::Point2i &place :
         {nori::Point2i(4, 3), nori::Point2i(1, 8), nori::Point2i(4, 3)}) {
        model.findFaulty();
        EXPECT_EQ(*model.cursor(), place);
    }
    ViewModel sound = makeModel();
    sound.findFaulty();
    EXPECT_FALSE(sound.cursor());
    EXPECT_NE(sound.statusLine().find("no pixel is NaN"), std::string::npos);
}

TEST(ViewModel, ComparesWithAReferenceOfTheSameSize) {
    ViewModel model = makeModel();
    EXPECT_FALSE(model.error());
    model.setReference(makeImage(40, 20), "truth.exr");
    ASSERT_TRUE(model.error());
    EXPECT_EQ(model.error()->rmse, 0.0);
    EXPECT_EQ(model.referenceLine(), "truth.exr");
    model.pointAt(5, 105);
    EXPECT_EQ(model.pixelLines().size(), 4u);
}

TEST(ViewModel, StretchesAReferenceOfAnotherSizeAndGivesNoNumbers) {
    ViewModel model = makeModel();
    model.setReference(makeImage(20, 10), "small.exr");
    EXPECT_TRUE(model.hasReference());
    EXPECT_FALSE(model.error());
    EXPECT_NE(model.referenceLine().find("--size 20x10"), std::string::npos);
    Look look;
    look.view = View::Reference;
    model.setLook(look);
    EXPECT_EQ(model.colors().size(), 800u);
}

TEST(ViewModel, SaysWhyAReferenceCannotBeRead) {
    ViewModel model = makeModel();
    model.loadReference("/nowhere/truth.exr");
    EXPECT_FALSE(model.hasReference());
    EXPECT_NE(model.statusLine().find("/nowhere/truth.exr"), std::string::npos);
}

TEST(ViewModel, ColorsAnewOnlyAfterAChange) {
    ViewModel model = makeModel();
    model.setReference(makeImage(40, 20), "truth.exr");
    model.colors();
    const unsigned first = model.revision();
    model.setLook(model.look());
    model.colors();
    EXPECT_EQ(model.revision(), first);
    model.holdReference(true);
    model.colors();
    EXPECT_EQ(model.revision(), first + 1);
    model.holdReference(true);
    model.colors();
    EXPECT_EQ(model.revision(), first + 1);
}

TEST(ViewModel, ExposesForTheBrightestHundredth) {
    nori::Bitmap image(nori::Vector2i(100, 10));
    image.setConstant(nori::Color3f(0.25f));
    image.coeffRef(0, 0) = nori::Color3f(1e6f);
    image.coeffRef(0, 1) = nori::Color3f(NAN);
    ViewModel model("image.exr", nullptr);
    model.setImage(image);
    model.normalize();
    EXPECT_EQ(model.look().exposure, 2.0);
    model.reset();
    EXPECT_EQ(model.look().exposure, 0.0);
}

TEST(ViewModel, ShowsNothingBeforeThereIsAnImage) {
    ViewModel model("image.exr", nullptr);
    model.setArea(100, 100);
    model.moveCursor(1, 1);
    model.normalize();
    model.findFaulty();
    EXPECT_FALSE(model.hasImage());
    EXPECT_FALSE(model.cursor());
    EXPECT_TRUE(model.colors().empty());
}

} // namespace
} // namespace preview
