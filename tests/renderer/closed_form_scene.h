// SPDX-License-Identifier: MIT
#pragma once

#include <nori/camera.h>
#include <nori/emitter.h>
#include <nori/integrator.h>
#include <nori/sampler.h>
#include <nori/scene.h>
#include <statistics/mean_tests.h>

#include <gtest/gtest.h>
#include <pcg32.h>

#include "fixtures.h"

/// Scenes with a point whose reflected light is known, and the test that an integrator finds it.
namespace nori::test {

inline constexpr double kLevel = 1e-6;
inline constexpr double kPower = 0.999;
inline const Color3f kAlbedo(0.37f, 0.62f, 0.81f);
inline const Color3f kRadiance(3.1f, 1.7f, 0.6f);
inline const Vector3f kPoint(0.13f, -0.21f, 0.0f);

class RandomSampler : public Sampler {
public:
    explicit RandomSampler(uint64_t seed) { m_random.seed(seed, 1); }

    std::unique_ptr<Sampler> clone() const override {
        return std::make_unique<RandomSampler>(*this);
    }

    void prepare(const ImageBlock &) override {}

    void generate() override {}

    void advance() override {}

    float next1D() override { return m_random.nextFloat(); }

    Point2f next2D() override {
        const float x = m_random.nextFloat();
        return {x, m_random.nextFloat()};
    }

    std::string toString() const override { return "Random[]"; }

private:
    pcg32 m_random;
};

inline std::unique_ptr<Scene> emptyScene(const std::string &emitterSampling = "uniform") {
    PropertyList props;
    props.setString("emitterSampling", emitterSampling);
    auto scene = std::make_unique<Scene>(props);
    scene->addChild(make<Integrator>("direct_ems").release());
    scene->addChild(make<Camera>("perspective").release());
    return scene;
}

/// \param vertices  relative to kPoint
inline void addMesh(Scene &scene, const std::vector<Eigen::Vector3d> &vertices,
                    const std::vector<Vector3i> &faces, const Color3f &radiance) {
    std::vector<Point3f> positions;
    for (const Eigen::Vector3d &vertex : vertices)
        positions.emplace_back(kPoint + vertex.cast<float>());
    auto mesh = std::make_unique<TestMesh>(positions, faces);
    PropertyList props;
    props.setColor("albedo", kAlbedo);
    mesh->addChild(make<NoriObject>("diffuse", props).release());
    if (radiance.maxCoeff() > 0.0f) {
        PropertyList light;
        light.setColor("radiance", radiance);
        auto area = make<Emitter>("area", light);
        area->setParent(mesh.get());
        mesh->addChild(area.release());
    }
    mesh->activate();
    scene.addChild(mesh.release());
}

/// A convex polygon as a fan; it faces where its vertices are seen counterclockwise.
inline void addPolygon(Scene &scene, const std::vector<Eigen::Vector3d> &vertices,
                       const Color3f &radiance = kRadiance) {
    std::vector<Vector3i> faces;
    for (int i = 2; i < static_cast<int>(vertices.size()); ++i)
        faces.emplace_back(0, i - 1, i);
    addMesh(scene, vertices, faces, radiance);
}

inline void addFloor(Scene &scene) {
    addPolygon(scene, {{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}}, Color3f(0.0f));
}

/// What `integrator` sees at kPoint.
class View {
public:
    View(const Scene &scene, const std::string &integrator,
         const Vector3f &from = Vector3f(-0.7f, 0.4f, 0.5f))
        : m_scene(scene),
          m_integrator(make<Integrator>(integrator)),
          m_ray(kPoint + from, -from.normalized()) {}

    Color3f sample(Sampler &sampler) const { return m_integrator->Li(&m_scene, &sampler, m_ray); }

    /// Moments of f(green sample).
    template <typename F>
    statistics::MomentSummary moments(int count, const F &f) const {
        RandomSampler sampler(7);
        statistics::RunningMoments result;
        for (int i = 0; i < count; ++i)
            result.add(f(static_cast<double>(sample(sampler).g())));
        return result.summary();
    }

private:
    const Scene &m_scene;
    std::unique_ptr<Integrator> m_integrator;
    Ray3f m_ray;
};

inline const double kAlbedoOverPi = static_cast<double>(kAlbedo.g()) / kPi;
/// What reflects an irradiance of 1 under radiances of 1.
inline const double kScale = kAlbedoOverPi * static_cast<double>(kRadiance.g());

/// Expects the mean to be `expected`, and the test to tell it from one that is `planted` off.
inline void expectMean(const statistics::MomentSummary &moments, double expected, double planted) {
    const auto test = statistics::oneSampleTest(moments, expected);
    if (test.standardError < 1e-6 * expected) { // no variance: rounding of floats is left
        EXPECT_NEAR(moments.mean, expected, 1e-5 * expected);
        return;
    }
    EXPECT_TRUE(test.gateMet);
    EXPECT_GT(test.pValue, kLevel) << moments.mean << " instead of " << expected;
    EXPECT_LT(statistics::detectableDifference(test.standardError, kLevel, kPower),
              planted * expected);
    EXPECT_LT(statistics::oneSampleTest(moments, expected * (1.0 + planted)).pValue, kLevel);
    EXPECT_LT(statistics::oneSampleTest(moments, expected * (1.0 - planted)).pValue, kLevel);
}

inline double identity(double value) {
    return value;
}

/// The second moment about the known mean: it tells how directions are drawn.
inline void expectVariance(const Scene &scene, double mean, double variance, double planted) {
    const auto squares = View(scene, "direct_ems").moments(200000, [mean](double value) {
        return (value - mean) * (value - mean);
    });
    expectMean(squares, variance, planted);
}

} // namespace nori::test
