// SPDX-License-Identifier: MIT
#include <nori/camera.h>
#include <nori/integrator.h>
#include <nori/sampler.h>
#include <nori/scene.h>

#include <gtest/gtest.h>

#include "fixtures.h"

namespace nori {
namespace {

void addPointLight(Scene &scene, float intensity) {
    PropertyList props;
    props.setColor("radiance", Color3f(intensity));
    scene.addChild(NoriObjectFactory::createInstance("pointlight", props));
}

/// A scene with point lights of these intensities, chosen by "uniform" or "power".
std::unique_ptr<Scene> makeScene(const std::string &emitterSampling,
                                 const std::vector<float> &intensities) {
    PropertyList props;
    props.setString("emitterSampling", emitterSampling);
    auto scene = std::make_unique<Scene>(props);
    scene->addChild(test::make<Integrator>("direct_ems").release());
    scene->addChild(test::make<Camera>("perspective").release());
    for (const float intensity : intensities)
        addPointLight(*scene, intensity);
    scene->activate();
    return scene;
}

/// How often each light is drawn, over a grid of inputs.
std::vector<double> frequencies(const Scene &scene) {
    constexpr int kCount = 10000;
    std::vector<double> result(scene.getLights().size());
    for (int i = 0; i < kCount; ++i) {
        float pdf = 0.0f;
        const Emitter *emitter = scene.sampleEmitter((static_cast<float>(i) + 0.5f) / kCount, pdf);
        EXPECT_FLOAT_EQ(pdf, scene.pdfEmitter(emitter));
        for (size_t j = 0; j < result.size(); ++j)
            result[j] += scene.getLights()[j] == emitter ? 1.0 / kCount : 0.0;
    }
    return result;
}

TEST(Scene, ChoosesEmittersUniformly) {
    const auto scene = makeScene("uniform", {1, 2, 5});
    for (const double frequency : frequencies(*scene))
        EXPECT_NEAR(frequency, 1.0 / 3.0, 2e-4);
    float pdf = 0.0f;
    EXPECT_EQ(scene->sampleEmitter(1.0f - 0x1p-24f, pdf), scene->getLights()[2]);
}

TEST(Scene, ChoosesEmittersByPower) {
    const auto scene = makeScene("power", {1, 2, 5});
    const std::vector<double> result = frequencies(*scene);
    EXPECT_NEAR(result[0], 1.0 / 8.0, 2e-4);
    EXPECT_NEAR(result[1], 2.0 / 8.0, 2e-4);
    EXPECT_NEAR(result[2], 5.0 / 8.0, 2e-4);
}

TEST(Scene, NeverChoosesAnEmitterWithoutPower) {
    const auto scene = makeScene("power", {0, 3, 0});
    for (const float u : {0.0f, 1e-38f, 0.5f, 1.0f - 0x1p-24f}) {
        float pdf = 0.0f;
        EXPECT_EQ(scene->sampleEmitter(u, pdf), scene->getLights()[1]) << u;
        EXPECT_EQ(pdf, 1.0f);
    }
}

TEST(Scene, ChoosesUniformlyWhereAllPowersAreZero) {
    const auto scene = makeScene("power", {0, 0});
    float pdf = 0.0f;
    EXPECT_NE(scene->sampleEmitter(0.7f, pdf), nullptr);
    EXPECT_FLOAT_EQ(pdf, 0.5f);
}

TEST(Scene, SaysThatThereIsNoEmitter) {
    const auto scene = makeScene("uniform", {});
    float pdf = 0.0f;
    EXPECT_THROW(scene->sampleEmitter(0.5f, pdf), NoriException);
    const auto sampler = scene->getSampler()->clone();
    const Ray3f ray(Point3f(0.0f), Vector3f(0, 0, 1));
    EXPECT_TRUE((scene->getIntegrator()->Li(scene.get(), sampler.get(), ray) == 0.0f).all());
}

TEST(Scene, WeighsAnEnvironmentBySceneSize) {
    PropertyList props;
    props.setString("emitterSampling", "power");
    Scene scene(props);
    scene.addChild(test::make<Integrator>("direct_ems").release());
    scene.addChild(test::make<Camera>("perspective").release());
    scene.addChild(test::make<Emitter>("environment").release());
    addPointLight(scene, 1.0f);
    auto square = test::makeSquare(0.0f, true); // radius sqrt(2)
    square->activate();
    scene.addChild(square.release());
    scene.activate();
    const float environment = 4.0f * M_PI * M_PI * 2.0f;
    const float point = 4.0f * M_PI;
    EXPECT_NEAR(scene.pdfEmitter(scene.getEnvironmentalEmitter()),
                environment / (environment + point), 1e-4f);
}

TEST(Scene, ListsMeshEmittersLastAndFreesAllOnce) {
    Scene scene{PropertyList()};
    scene.addChild(test::make<Integrator>("direct_ems").release());
    scene.addChild(test::make<Camera>("perspective").release());
    auto square = test::makeSquare(1.0f, false);
    auto area = test::make<Emitter>("area");
    Emitter *const light = area.get();
    square->addChild(area.release());
    light->setParent(square.get());
    square->activate();
    scene.addChild(square.release());
    addPointLight(scene, 1.0f);
    scene.activate();
    ASSERT_EQ(scene.getLights().size(), 2u);
    EXPECT_EQ(scene.getLights()[1], light);
    EXPECT_FALSE(scene.toString().empty());
}

TEST(Scene, NeedsIntegratorAndCameraAndOneEnvironmentAtMost) {
    EXPECT_THROW(Scene(PropertyList()).activate(), NoriException);
    Scene scene{PropertyList()};
    scene.addChild(test::make<Emitter>("environment").release());
    const auto second = test::make<Emitter>("environment");
    EXPECT_THROW(scene.addChild(second.get()), NoriException);
    PropertyList props;
    props.setString("emitterSampling", "brightest");
    EXPECT_THROW(const Scene unknown(props), NoriException);
}

} // namespace
} // namespace nori
