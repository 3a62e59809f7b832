// SPDX-License-Identifier: MIT
#include <cmath>
#include <vector>

#include "closed_form_scene.h"

// Point lights, whose light is known exactly.

namespace nori {
namespace {

using test::RandomSampler;
using test::View;

struct PointLight {
    Eigen::Vector3d position; ///< relative to kPoint
    double intensity;         ///< green [W/sr]
};

const std::vector<PointLight> kPointLights{
    {{0.4, -0.3, 1.2}, 2.0}, {{-1.5, 0.8, 0.6}, 11.0}, {{0.2, 2.1, 3.4}, 40.0}};

std::unique_ptr<Scene> pointLightScene(const std::string &emitterSampling) {
    auto scene = test::emptyScene(emitterSampling);
    test::addFloor(*scene);
    for (const PointLight &light : kPointLights) {
        PropertyList props;
        props.setPoint("position", test::kPoint + light.position.cast<float>());
        props.setColor("radiance", Color3f(static_cast<float>(light.intensity)));
        scene->addChild(test::make<Emitter>("pointlight", props).release());
    }
    scene->activate();
    return scene;
}

/// What each light contributes to the reflected radiance.
std::vector<double> contributions() {
    std::vector<double> result;
    for (const PointLight &light : kPointLights)
        result.push_back(test::kAlbedoOverPi * light.intensity * light.position.z() /
                         std::pow(light.position.norm(), 3));
    return result;
}

double sumOf(const std::vector<double> &values) {
    double sum = 0.0;
    for (const double value : values)
        sum += value;
    return sum;
}

TEST(PointLights, AreSummedUpExactlyByWhitted) {
    const auto scene = pointLightScene("uniform");
    RandomSampler sampler(1);
    const double expected = sumOf(contributions());
    EXPECT_NEAR(static_cast<double>(View(*scene, "direct_whitted").sample(sampler).g()), expected,
                1e-6 * expected);
}

/// Gives the choice of the light, then anything.
class ChoosingSampler : public RandomSampler {
public:
    explicit ChoosingSampler(float choice) : RandomSampler(1), m_choice(choice) {}

    float next1D() override {
        const float value = m_choice;
        m_choice = 0.5f;
        return value;
    }

private:
    float m_choice;
};

class PointLightChoices : public testing::TestWithParam<const char *> {};

TEST_P(PointLightChoices, GiveWhittedsImageInTheMeanForEveryRay) {
    const auto scene = pointLightScene(GetParam());
    RandomSampler any(1);
    for (const Vector3f &from : {Vector3f(0.9f, 0.2f, 0.7f), Vector3f(-0.1f, 0.5f, 2.0f)}) {
        const View ems(*scene, "direct_ems", from);
        double mean = 0.0;
        double begin = 0.0;
        for (const Emitter *light : scene->getLights()) {
            const double probability = static_cast<double>(scene->pdfEmitter(light));
            ChoosingSampler sampler(static_cast<float>(begin + 0.5 * probability));
            mean += probability * static_cast<double>(ems.sample(sampler).g());
            begin += probability;
        }
        const double expected =
            static_cast<double>(View(*scene, "direct_whitted", from).sample(any).g());
        EXPECT_NEAR(mean, expected, 1e-6 * expected);
    }
}

TEST_P(PointLightChoices, HaveTheVarianceOfTheirProbabilities) {
    const auto scene = pointLightScene(GetParam());
    const std::vector<double> values = contributions();
    double secondMoment = 0.0;
    for (size_t i = 0; i < values.size(); ++i)
        secondMoment +=
            values[i] * values[i] / static_cast<double>(scene->pdfEmitter(scene->getLights()[i]));
    const double mean = sumOf(values);
    test::expectVariance(*scene, mean, secondMoment - mean * mean, 0.1);
    test::expectMean(View(*scene, "direct_ems").moments(60000, test::identity), mean, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Sampling, PointLightChoices, testing::Values("uniform", "power"),
                         [](const auto &choice) { return std::string(choice.param); });

} // namespace
} // namespace nori
