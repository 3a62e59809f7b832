// SPDX-License-Identifier: MIT
#include <nori/emitter.h>

#include <gtest/gtest.h>

#include "fixtures.h"

namespace nori {
namespace {

/// The square [-1, 1]^2 at height 1 that shines down, with radiance (1, 2, 3) times 2.
struct Light {
    std::unique_ptr<test::TestMesh> mesh = test::makeSquare(1.0f, false);
    Emitter *emitter = nullptr; ///< owned by the mesh

    explicit Light(NoriObject *texture = nullptr) {
        PropertyList props;
        props.setColor("radiance", Color3f(1, 2, 3));
        props.setFloat("scale", 2.0f);
        emitter = static_cast<Emitter *>(NoriObjectFactory::createInstance("area", props));
        if (texture != nullptr)
            emitter->addChild(texture, "radiance");
        emitter->activate();
        mesh->addChild(emitter);
        emitter->setParent(mesh.get());
        mesh->activate();
    }
};

EmitterQueryRecord seenFrom(const Light &light, const Point3f &ref) {
    return {light.emitter, ref, Point3f(0.5f, 0.5f, 1), Normal3f(0, 0, -1), Point2f(0.5f, 0.5f)};
}

TEST(AreaEmitter, ShinesOnTheSideOfItsNormalOnly) {
    const Light light;
    EXPECT_TRUE((light.emitter->eval(seenFrom(light, {0, 0, 0})) == Color3f(2, 4, 6)).all());
    EXPECT_TRUE((light.emitter->eval(seenFrom(light, {0, 0, 2})) == 0.0f).all());
    EXPECT_TRUE((light.emitter->eval(seenFrom(light, {0, 0, 1})) == 0.0f).all()); // edge-on
}

TEST(AreaEmitter, ReturnsRadianceOverTheSolidAngleDensity) {
    const Light light;
    double solidAngle = 0.0;
    const std::vector<Point2f> inputs = test::squareGrid(64);
    for (const Point2f &u : inputs) {
        EmitterQueryRecord lRec(Point3f(0, 0, 0));
        const Color3f value = light.emitter->sample(lRec, u, 0.5f);
        ASSERT_EQ(lRec.emitter, light.emitter);
        EXPECT_NEAR(lRec.dist, (lRec.p - lRec.ref).norm(), 1e-6f);
        EXPECT_NEAR((lRec.ref + lRec.dist * lRec.wi - lRec.p).norm(), 0.0f, 1e-6f);
        EXPECT_NEAR((lRec.uv - Point2f(lRec.p.x(), lRec.p.y())).norm(), 0.0f, 1e-6f);
        // area 4, distance d, cosine 1/d
        const float expected = lRec.dist * lRec.dist * lRec.dist / 4.0f;
        EXPECT_NEAR(lRec.pdf / expected, 1.0f, 1e-5f);
        EXPECT_NEAR(light.emitter->pdf(lRec) / expected, 1.0f, 1e-5f);
        EXPECT_NEAR(value.g() * lRec.pdf, 4.0f, 1e-4f);
        solidAngle += 1.0 / static_cast<double>(lRec.pdf) / static_cast<double>(inputs.size());
    }
    // 4 asin(1/2): a square of half side 1 from distance 1. A forgotten cosine gives 3.2 instead.
    EXPECT_NEAR(solidAngle, 2.0 * test::kPi / 3.0, 1e-3);
}

TEST(AreaEmitter, GivesNoLightBehindOrBesideItself) {
    const Light light;
    EmitterQueryRecord behind(Point3f(0, 0, 2));
    EXPECT_TRUE((light.emitter->sample(behind, {0.3f, 0.3f}, 0.0f) == 0.0f).all());
    EmitterQueryRecord beside(Point3f(5, 0, 1));
    EXPECT_TRUE((light.emitter->sample(beside, {0.3f, 0.3f}, 0.0f) == 0.0f).all());
    EXPECT_EQ(beside.pdf, 0.0f);
}

TEST(AreaEmitter, LooksUpItsTexture) {
    PropertyList checker; // cells of side 1 in uv = (x, y): 0.9 where x and y have the same parity
    const Light light(NoriObjectFactory::createInstance("checker", checker));
    EXPECT_FLOAT_EQ(light.emitter->eval(seenFrom(light, {0, 0, 0})).r(), 1.8f);
    // truncation makes one cell of all of it: power = pi * 4 * 2 * 0.9
    EXPECT_NEAR(light.emitter->power().g(), M_PI * 7.2f, 1e-3f);
}

TEST(AreaEmitter, EmitsPiTimesAreaTimesRadiance) {
    const Light light;
    EXPECT_NEAR(light.emitter->power().b(), M_PI * 4.0f * 6.0f, 1e-3f);
}

TEST(AreaEmitter, NeedsAMesh) {
    const auto emitter = test::make<Emitter>("area");
    EmitterQueryRecord lRec(Point3f(0.0f));
    EXPECT_THROW(emitter->sample(lRec, {0.5f, 0.5f}, 0.5f), NoriException);
    EXPECT_THROW(emitter->pdf(lRec), NoriException);
    EXPECT_THROW(emitter->eval(lRec), NoriException);
}

} // namespace
} // namespace nori
