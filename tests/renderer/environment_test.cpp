// SPDX-License-Identifier: MIT
#include <nori/bitmap.h>
#include <nori/emitter.h>
#include <nori/warp.h>

#include <gtest/gtest.h>

#include <cmath>

#include "fixtures.h"

namespace nori {
namespace {

EmitterQueryRecord towards(const Vector3f &wi) {
    EmitterQueryRecord lRec;
    lRec.wi = wi;
    return lRec;
}

PropertyList properties(const std::string &filename, const std::string &sampling) {
    PropertyList props;
    props.setString("filename", filename);
    props.setString("sampling", sampling);
    props.setColor("radiance", Color3f(255.0f, 127.5f, 255.0f));
    return props;
}

/// A map with a sun, a black half and a gradient; texels in [0, 50].
std::string writeMap(const test::TemporaryFolder &folder) {
    Bitmap map(Vector2i(16, 8));
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 16; ++x)
            map.coeffRef(y, x) = x < 8 ? Color3f(0.0f) : Color3f(0.1f * static_cast<float>(y + 1));
    }
    map.coeffRef(2, 12) = Color3f(50.0f, 40.0f, 30.0f);
    map.saveEXR(folder.file("map"));
    return folder.file("map.exr");
}

struct Estimate {
    double mean = 0.0;
    double variance = 0.0; ///< of one sample
};

/// Estimates the integral of `f` times the green radiance over the sphere, on a grid of inputs.
template <typename F>
Estimate integrate(const Emitter &emitter, int cells, const F &f) {
    double sum = 0.0, squares = 0.0;
    const std::vector<Point2f> inputs = test::squareGrid(cells);
    for (const Point2f &u : inputs) {
        EmitterQueryRecord lRec(Point3f(1, 2, 3));
        const Color3f weight = emitter.sample(lRec, u, 0.5f);
        const auto value = static_cast<double>(f(lRec.wi) * weight.g());
        sum += value;
        squares += value * value;
    }
    const auto count = static_cast<double>(inputs.size());
    return {sum / count, squares / count - sum * sum / (count * count)};
}

float upperCosine(const Vector3f &wi) {
    return std::max(0.0f, wi.z());
}

TEST(EnvironmentEmitter, LightsAPlaneWithPiTimesItsConstantRadiance) {
    PropertyList props;
    props.setColor("radiance", Color3f(2.0f));
    const auto emitter = test::make<Emitter>("environment", props);
    const Estimate result = integrate(*emitter, 256, upperCosine);
    EXPECT_NEAR(result.mean / (2.0 * test::kPi), 1.0, 1e-3);
    // uniform directions: E[f^2] = 8/3 (pi L)^2
    EXPECT_NEAR(result.variance / std::pow(2.0 * test::kPi, 2), 5.0 / 3.0, 1e-2);
    EXPECT_FLOAT_EQ(emitter->pdf(towards(Vector3f(0, 1, 0))), INV_FOURPI);
    EXPECT_NEAR(emitter->power().r(), 4.0f * M_PI * M_PI * 2.0f, 1e-2f);
}

TEST(EnvironmentEmitter, FillsTheWholeRecord) {
    const auto emitter = test::make<Emitter>("environment");
    EmitterQueryRecord lRec(Point3f(1, 2, 3));
    emitter->sample(lRec, {0.3f, 0.7f}, 0.5f);
    EXPECT_EQ(lRec.emitter, emitter.get());
    EXPECT_FLOAT_EQ(lRec.wi.norm(), 1.0f);
    EXPECT_FLOAT_EQ(lRec.pdf, INV_FOURPI);
    EXPECT_NEAR(((lRec.p - lRec.ref) / lRec.dist - lRec.wi).norm(), 0.0f, 1e-5f);
    EXPECT_LT(lRec.n.dot(lRec.wi), 0.0f);
}

TEST(EnvironmentEmitter, DrawsAMapInProportionWithoutBias) {
    const test::TemporaryFolder folder;
    const std::string path = writeMap(folder);
    const auto uniform = test::make<Emitter>("environment", properties(path, "uniform"));
    const auto map = test::make<Emitter>("environment", properties(path, "map"));
    const auto tilted = [](const Vector3f &wi) {
        return 1.5f + wi.x() + 0.3f * wi.y();
    };
    const Estimate expected = integrate(*uniform, 1000, tilted);
    const Estimate result = integrate(*map, 300, tilted);
    EXPECT_NEAR(result.mean / expected.mean, 1.0, 5e-3); // the grid's error on the sun's edge
    EXPECT_LT(result.variance, 0.1 * expected.variance);
}

TEST(EnvironmentEmitter, HasAMapDensityThatIntegratesToOneAndCoversTheLight) {
    const test::TemporaryFolder folder;
    const auto emitter = test::make<Emitter>("environment", properties(writeMap(folder), "map"));
    double sum = 0.0;
    const std::vector<Point2f> inputs = test::squareGrid(600);
    for (const Point2f &u : inputs) {
        const EmitterQueryRecord lRec = towards(Warp::squareToUniformSphere(u));
        const float pdf = emitter->pdf(lRec);
        sum += static_cast<double>(pdf) * 4.0 * test::kPi / static_cast<double>(inputs.size());
        ASSERT_TRUE(pdf > 0.0f || emitter->eval(lRec).maxCoeff() == 0.0f) << lRec.wi.toString();
    }
    EXPECT_NEAR(sum, 1.0, 5e-3);
}

TEST(EnvironmentEmitter, StaysFiniteAtTheEdgesOfTheSquareAndAtThePoles) {
    const test::TemporaryFolder folder;
    const auto emitter = test::make<Emitter>("environment", properties(writeMap(folder), "map"));
    for (const Point2f &u : test::edgeInputs()) {
        EmitterQueryRecord lRec(Point3f(0, 0, 0));
        EXPECT_TRUE(emitter->sample(lRec, u, 0.5f).allFinite()) << u.toString();
        EXPECT_TRUE(std::isfinite(lRec.pdf)) << u.toString();
    }
    for (const float y : {1.0000001f, -1.0000001f}) // unit vectors after rounding
        EXPECT_TRUE(emitter->eval(towards(Vector3f(0, y, 0))).allFinite());
}

TEST(EnvironmentEmitter, SamplesABlackMapUniformly) {
    const test::TemporaryFolder folder;
    Bitmap(Vector2i(4, 2)).saveEXR(folder.file("black"));
    const auto emitter =
        test::make<Emitter>("environment", properties(folder.file("black.exr"), "map"));
    EmitterQueryRecord lRec(Point3f(0, 0, 0));
    EXPECT_TRUE((emitter->sample(lRec, {0.3f, 0.7f}, 0.5f) == 0.0f).all());
    EXPECT_FLOAT_EQ(lRec.pdf, INV_FOURPI);
}

TEST(EnvironmentEmitter, TurnsOnlyWhenToldTo) {
    const test::TemporaryFolder folder;
    PropertyList props = properties(writeMap(folder), "uniform");
    const auto plain = test::make<Emitter>("environment", props);
    props.setFloat("rotate", 90.0f);
    testing::internal::CaptureStderr();
    const auto ignored = test::make<Emitter>("environment", props);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("rotate"), std::string::npos);
    props.setBoolean("applyRotate", true);
    const auto turned = test::make<Emitter>("environment", props);

    const Vector3f wi = Vector3f(0.3f, 0.2f, 0.8f).normalized();
    const Vector3f quarter(wi.z(), wi.y(), -wi.x()); // right-handed about +y: z goes to x
    const Color3f expected = plain->eval(towards(wi));
    ASSERT_GT(expected.g(), 0.0f);
    EXPECT_TRUE((ignored->eval(towards(wi)) == expected).all());
    EXPECT_LT((turned->eval(towards(quarter)) - expected).abs().maxCoeff(), 1e-3f);
}

TEST(EnvironmentEmitter, RefusesAFileItCannotReadAndUnknownSampling) {
    EXPECT_THROW(test::make<Emitter>("environment", properties("no such.exr", "uniform")),
                 NoriException);
    EXPECT_THROW(test::make<Emitter>("environment", properties("null", "best")), NoriException);
}

} // namespace
} // namespace nori
