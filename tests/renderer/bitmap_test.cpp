// SPDX-License-Identifier: MIT
#include <nori/bitmap.h>

#include <gtest/gtest.h>

#include <fstream>

#include "fixtures.h"

namespace nori {
namespace {

Bitmap gradient() {
    Bitmap bitmap(Vector2i(3, 2));
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 3; ++x)
            bitmap.coeffRef(y, x) =
                Color3f(static_cast<float>(x) / 2.0f, static_cast<float>(y), 0.25f);
    }
    return bitmap;
}

TEST(Bitmap, ReadsTheEXRFileItWrote) {
    const test::TemporaryFolder folder;
    const Bitmap bitmap = gradient();
    bitmap.saveEXR(folder.file("ñandú"));
    const Bitmap copy(folder.file("ñandú.exr"));
    ASSERT_EQ(copy.cols(), 3);
    ASSERT_EQ(copy.rows(), 2);
    for (Eigen::Index i = 0; i < bitmap.size(); ++i)
        EXPECT_TRUE((copy.data()[i] == bitmap.data()[i]).all()) << i;
    EXPECT_FALSE(std::filesystem::exists(folder.file("ñandú.exr.part")));
}

TEST(Bitmap, WritesAPNGWithTheSRGBCurve) {
    const test::TemporaryFolder folder;
    Bitmap bitmap(Vector2i(4, 1));
    bitmap.coeffRef(0, 0) = Color3f(0.0f);
    bitmap.coeffRef(0, 1) = Color3f(0.2158605f); // sRGB 0.5019 = 128/255
    bitmap.coeffRef(0, 2) = Color3f(7.0f);
    bitmap.coeffRef(0, 3) = Color3f(NAN);
    bitmap.savePNG(folder.file("a"));
    const LDRBitmap copy(folder.file("a.png"));
    EXPECT_EQ(copy.coeff(0, 0)[0], 0);
    EXPECT_NEAR(copy.coeff(0, 1)[1], 128, 1);
    EXPECT_EQ(copy.coeff(0, 2)[2], 255);
    EXPECT_EQ(copy.coeff(0, 3)[0], 0);
}

TEST(Bitmap, LooksUpFromTheFarEndAndDividesBy255) {
    const Bitmap bitmap = gradient();
    // u = 1, v = 1 is column 0, row 0; u = 0 wraps to it as well
    EXPECT_FLOAT_EQ(bitmap.eval({1.0f, 1.0f}).b(), 0.25f / 255.0f);
    EXPECT_FLOAT_EQ(bitmap.eval({1.0f, 1.0f}).r(), 0.0f);
    EXPECT_FLOAT_EQ(bitmap.eval({0.0f, 0.0f}).g(), 0.0f);
    EXPECT_NEAR(bitmap.eval({1.0f / 3.0f, 0.5f}).r(), 1.0f / 255.0f, 1e-6f); // column 2, row 1
    EXPECT_NEAR(bitmap.eval({1.0f / 3.0f, 0.5f}).g(), 1.0f / 255.0f, 1e-6f);
    EXPECT_NEAR(bitmap.eval({5.0f / 6.0f, 1.0f}).r(), 0.25f / 255.0f, 1e-6f); // half-way to 1
    for (const float u : {-7.3f, 1e20f, NAN, INFINITY})
        EXPECT_TRUE(bitmap.eval({u, 0.5f}).allFinite()) << u;
    EXPECT_TRUE((Bitmap().eval({0.5f, 0.5f}) == 0.0f).all());
}

TEST(Bitmap, NamesTheFileItCannotRead) {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("broken.exr");
    std::ofstream(path) << "this is not an image";
    for (const std::string &name : {path, folder.file("missing.exr")}) {
        try {
            const Bitmap bitmap(name);
            ADD_FAILURE() << name;
        } catch (const NoriException &error) {
            EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
        }
        EXPECT_THROW(const LDRBitmap bitmap(name), NoriException);
    }
}

TEST(Bitmap, RefusesATruncatedFile) {
    const test::TemporaryFolder folder;
    gradient().saveEXR(folder.file("a"));
    gradient().savePNG(folder.file("a"));
    for (const char *name : {"a.exr", "a.png"}) {
        const std::string path = folder.file(name);
        std::filesystem::resize_file(path, std::filesystem::file_size(path) * 2 / 3);
    }
    EXPECT_THROW(const Bitmap bitmap(folder.file("a.exr")), NoriException);
    EXPECT_THROW(const LDRBitmap bitmap(folder.file("a.png")), NoriException);
}

TEST(Bitmap, LeavesNothingBehindWhereItCannotWrite) {
    const Bitmap bitmap = gradient();
    EXPECT_THROW(bitmap.saveEXR("/no/such/folder/a"), NoriException);
    EXPECT_THROW(bitmap.savePNG("/no/such/folder/a"), NoriException);
}

} // namespace
} // namespace nori
