// SPDX-License-Identifier: MIT
#include <nori/camera.h>
#include <nori/integrator.h>
#include <nori/sampler.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fixtures.h"
#include "moment_render.h"

// The integrators direct_mats and direct_mis, which are there to show that direct_ems is right.

namespace nori {
namespace {

using test::MomentRender;

const Vector2i kSize(64, 48);
constexpr int kSpp = 64;
constexpr double kLevel = 1e-6; // family-wise over the channels of one comparison
constexpr int kWholeImage = 64; // as the size of a tile: see Comparison

/// What two algorithms say of one scene.
struct Comparison {
    const char *scene;
    const char *integrator;
    const char *other;
    /// Of tiles [pixels]. Sampling the BSDF finds a small light in few of a dark tile's samples,
    /// too few for a test (the skewness gate says so); over the whole image there are enough.
    int tileSize;
    double plantedError; ///< relative; found with a power above 0.999
};

std::string testName(const testing::TestParamInfo<Comparison> &row) {
    std::string name = std::filesystem::path(row.param.scene).stem().string() + "_" +
                       row.param.integrator + "_" + row.param.other;
    name.erase(std::remove(name.begin(), name.end(), '.'), name.end());
    return name;
}

/// The p-value of all channels together.
double pValue(const MomentRender &a, const MomentRender &b, int tileSize) {
    statistics::TileWelchConfig config;
    config.tileSize = tileSize;
    double least = 1.0;
    for (int c = 0; c < 3; ++c) {
        const auto result = statistics::tileWelchTest(a.channel(c), b.channel(c), config);
        EXPECT_TRUE(result.gateMet) << c;
        least = std::min(least, 3.0 * result.pValue);
    }
    return least;
}

class IndependentAlgorithms : public testing::TestWithParam<Comparison> {};

TEST_P(IndependentAlgorithms, AgreeAndWouldNotWithAWrongScale) {
    const Comparison &row = GetParam();
    const MomentRender a = test::renderScene(row.scene, row.integrator, kSize, kSpp, 1);
    const MomentRender b = test::renderScene(row.scene, row.other, kSize, kSpp, 2);
    EXPECT_GT(pValue(a, b, row.tileSize), kLevel);
    EXPECT_LT(pValue(a.scaled(1.0 + row.plantedError), b, row.tileSize), kLevel);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, IndependentAlgorithms,
    testing::Values(
        Comparison{"cbox/cbox_ems.xml", "direct_mats", "direct_ems", kWholeImage, 0.15},
        Comparison{"cbox/cbox_ems.xml", "direct_mis", "direct_ems", 16, 0.05},
        Comparison{"table/table_ems.xml", "direct_mats", "direct_ems", kWholeImage, 0.25},
        Comparison{"table/table_ems.xml", "direct_mis", "direct_ems", 16, 0.05},
        Comparison{"bunny/bunny_ems.xml", "direct_mats", "direct_mis", kWholeImage, 0.2},
        Comparison{"serapis/serapis_env.xml", "direct_mats", "direct_ems", 16, 0.05},
        Comparison{"serapis/serapis_env.xml", "direct_mis", "direct_ems", 16, 0.05},
        Comparison{"serapis/serapis_env_map.xml", "direct_mats", "direct_ems", 16, 0.05},
        Comparison{"serapis/serapis_env_map.xml", "direct_mis", "direct_ems", 16, 0.05},
        Comparison{"serapis/serapis_ems.xml", "direct_mis", "direct_whitted", 16, 0.08}),
    testName);

/// A square at z = 0 that is seen from above, and what else `add` puts in.
std::unique_ptr<Scene> makeScene(const std::string &bsdf, const std::function<void(Scene &)> &add) {
    auto scene = std::make_unique<Scene>(PropertyList());
    scene->addChild(test::make<Integrator>("direct_ems").release());
    scene->addChild(test::make<Camera>("perspective").release());
    auto square = test::makeSquare(0.0f, true);
    square->addChild(test::make<NoriObject>(bsdf).release());
    square->activate();
    scene->addChild(square.release());
    add(*scene);
    scene->activate();
    return scene;
}

void addEnvironment(Scene &scene) {
    PropertyList props;
    props.setColor("radiance", Color3f(2.0f, 3.0f, 5.0f));
    scene.addChild(test::make<Emitter>("environment", props).release());
}

void addPointLight(Scene &scene) {
    PropertyList props;
    props.setPoint("position", Point3f(0.3f, 0.2f, 1.7f));
    scene.addChild(test::make<Emitter>("pointlight", props).release());
}

/// One sample of what is seen from above at a slant; `integrator` is prepared for the scene.
Color3f look(const Scene &scene, const std::string &integrator, Sampler &sampler) {
    const auto object = test::make<Integrator>(integrator);
    object->preprocess(&scene);
    const Ray3f ray(Point3f(0.5f, 0.0f, 2.0f), Vector3f(-0.2f, 0.1f, -1.0f).normalized());
    return object->Li(&scene, &sampler, ray);
}

TEST(DirectLight, IsFoundByTheBsdfInAMirrorAndThroughGlass) {
    for (const char *bsdf : {"mirror", "dielectric"}) {
        const auto scene = makeScene(bsdf, addEnvironment);
        const auto sampler = test::make<Sampler>("independent");
        for (int i = 0; i < 32; ++i) {
            for (const char *integrator : {"direct_mats", "direct_mis"}) {
                const Color3f radiance = look(*scene, integrator, *sampler);
                EXPECT_LT((radiance - Color3f(2.0f, 3.0f, 5.0f)).abs().maxCoeff(), 1e-5f)
                    << bsdf << " " << integrator;
            }
            EXPECT_TRUE((look(*scene, "direct_ems", *sampler) == 0.0f).all()) << bsdf;
        }
    }
}

TEST(DirectLight, OfAPointIsExactWithBothAndMissedByTheBsdfAlone) {
    const auto scene = makeScene("diffuse", addPointLight);
    const auto sampler = test::make<Sampler>("independent");
    const Color3f expected = look(*scene, "direct_whitted", *sampler);
    EXPECT_GT(expected.minCoeff(), 0.01f);
    EXPECT_LT((look(*scene, "direct_mis", *sampler) - expected).abs().maxCoeff(), 1e-6f);

    testing::internal::CaptureStderr();
    EXPECT_TRUE((look(*scene, "direct_mats", *sampler) == 0.0f).all());
    EXPECT_NE(testing::internal::GetCapturedStderr().find("point lights"), std::string::npos);
}

TEST(DirectLight, IsTheBackgroundWhereNothingIsHitAndBlackWithoutAny) {
    const auto lit = makeScene("diffuse", addEnvironment);
    const auto dark = makeScene("diffuse", [](Scene &) {});
    const auto sampler = test::make<Sampler>("independent");
    const Ray3f up(Point3f(0.0f, 0.0f, 1.0f), Vector3f(0.0f, 0.0f, 1.0f));
    for (const char *type : {"direct_mats", "direct_mis"}) {
        const auto integrator = test::make<Integrator>(type);
        EXPECT_TRUE(
            (integrator->Li(lit.get(), sampler.get(), up) == Color3f(2.0f, 3.0f, 5.0f)).all());
        EXPECT_TRUE((integrator->Li(dark.get(), sampler.get(), up) == 0.0f).all());
        EXPECT_TRUE((look(*dark, type, *sampler) == 0.0f).all());
    }
}

} // namespace
} // namespace nori
