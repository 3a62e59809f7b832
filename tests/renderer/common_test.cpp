// SPDX-License-Identifier: MIT
#include <nori/color.h>
#include <nori/common.h>
#include <nori/frame.h>

#include <filesystem/resolver.h>
#include <gtest/gtest.h>
#include <pcg32.h>

namespace nori {
namespace {

TEST(Common, ParsesNumbersStrictly) {
    EXPECT_EQ(toInt("-12"), -12);
    EXPECT_EQ(toUInt("12"), 12u);
    EXPECT_FLOAT_EQ(toFloat("1e-3"), 1e-3f);
    EXPECT_TRUE(toBool("True"));
    EXPECT_EQ(toVector3f("1, 2 3"), Eigen::Vector3f(1, 2, 3));
    for (const char *text : {"", "1x", "1 ", "99999999999"})
        EXPECT_THROW(toInt(text), NoriException) << text;
    EXPECT_THROW(toUInt("-1"), NoriException);
    EXPECT_THROW(toFloat(""), NoriException);
    EXPECT_THROW(toFloat("1,5"), NoriException);
    EXPECT_THROW(toFloat("nan"), NoriException);
    EXPECT_EQ(toFloat("inf"), std::numeric_limits<float>::infinity());
    EXPECT_THROW(toBool("yes"), NoriException);
    EXPECT_THROW(toVector3f("1 2"), NoriException);
    EXPECT_THROW(toVector3f("1 2 3 4"), NoriException);
}

TEST(Common, CutsAndIndentsText) {
    EXPECT_EQ(tokenize("a, b  c"), (std::vector<std::string>{"a", "b", "c"}));
    EXPECT_EQ(tokenize("a,,b", ",", true), (std::vector<std::string>{"a", "", "b"}));
    EXPECT_TRUE(tokenize("").empty());
    EXPECT_EQ(indent("a\nb"), "a\n  b");
    EXPECT_TRUE(endsWith("scene.xml", ".xml"));
    EXPECT_FALSE(endsWith("l", ".xml"));
    EXPECT_EQ(timeString(90000.0), "1.5m");
    EXPECT_EQ(memString(1536), "1.5 KiB");
}

TEST(Common, FormatsLikePrintf) {
    EXPECT_EQ(tfm::format("%d %5.2f %-3s| %03d %x %% %s", 3, 2.5, "a", 7, 255, true),
              "3  2.50 a  | 007 ff % true");
    EXPECT_EQ(tfm::format("%+d %.3s %*d %c", 4, std::string("abcdef"), 4, 5, 'z'), "+4 abc    5 z");
    EXPECT_EQ(tfm::format("%s and %s", 1), "1 and (missing)");
    EXPECT_STREQ(NoriException("%s: %d", "file", 3).what(), "file: 3");
}

TEST(Common, KeepsFloatsInUnqualifiedMathematics) {
    // with <cmath> alone this would be int abs(int)
    EXPECT_EQ(abs(-0.5f), 0.5f);
    static_assert(std::is_same<decltype(M_PI), float>::value || sizeof(M_PI) == sizeof(float));
}

TEST(Common, ReflectsAsFresnelSays) {
    EXPECT_NEAR(fresnel(1.0f, 1.0f, 1.5f), 0.04f, 1e-6f); // ((n - 1) / (n + 1))^2
    EXPECT_NEAR(fresnel(-1.0f, 1.0f, 1.5f), 0.04f, 1e-6f);
    EXPECT_EQ(fresnel(-0.1f, 1.0f, 1.5f), 1.0f); // total reflection inside
    EXPECT_EQ(fresnel(0.3f, 1.5f, 1.5f), 0.0f);
}

TEST(Common, ConvertsDirectionsThereAndBack) {
    const Vector3f v = Vector3f(-0.3f, -0.5f, 0.2f).normalized();
    const Point2f angles = sphericalCoordinates(v);
    EXPECT_GE(angles.y(), 0.0f);
    EXPECT_LT((sphericalDirection(angles.x(), angles.y()) - v).norm(), 1e-6f);
    // a y slightly above 1 must not give NaN
    EXPECT_TRUE(sphericalCoordinates(Vector3f(0, 0, 1.0000001f)).allFinite());

    const Frame frame(v);
    EXPECT_LT((frame.toWorld(frame.toLocal(Vector3f(1, 2, 3))) - Vector3f(1, 2, 3)).norm(), 1e-5f);
    EXPECT_NEAR(frame.s.dot(frame.t), 0.0f, 1e-6f);
    EXPECT_EQ(Frame::cosPhi(Vector3f(0, 0, 1)), 1.0f);
}

TEST(Common, TellsValidColors) {
    EXPECT_TRUE(Color3f(0.0f, 1.0f, 1e30f).isValid());
    EXPECT_FALSE(Color3f(-1e-3f, 1.0f, 1.0f).isValid());
    EXPECT_FALSE(Color3f(INFINITY, 1.0f, 1.0f).isValid());
    EXPECT_FALSE(Color3f(NAN, 1.0f, 1.0f).isValid());
    const Color3f color(0.001f, 0.2f, 0.9f);
    EXPECT_LT((color.toSRGB().toLinearRGB() - color).abs().maxCoeff(), 1e-6f);
}

TEST(Common, DrawsThePublishedPcg32Sequence) {
    // pcg32-demo of https://www.pcg-random.org: seed 42, stream 54
    pcg32 random(42u, 54u);
    for (const uint32_t expected : {0xa15c02b7u, 0x7b47f409u, 0xba1d3330u, 0x83d2f293u})
        EXPECT_EQ(random.nextUInt(), expected);
    pcg32 ahead = random;
    ahead.advance(1000);
    EXPECT_EQ(ahead - random, 1000);
}

TEST(Common, ResolvesFilesInOrder) {
    filesystem::resolver resolver;
    EXPECT_EQ(resolver.resolve("no such file").str(), "no such file");
    resolver.prepend("/");
    EXPECT_EQ(resolver.resolve("proc").str(), "/proc");
    const filesystem::path path("/a/b.c/d.xml");
    EXPECT_EQ(path.extension(), "xml");
    EXPECT_EQ(path.filename(), "d.xml");
    EXPECT_EQ(path.parent_path().str(), "/a/b.c");
    EXPECT_EQ((path.parent_path() / "e").str(), "/a/b.c/e");
}

} // namespace
} // namespace nori
