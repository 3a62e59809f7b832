// SPDX-License-Identifier: MIT
#include <nori/parser.h>
#include <nori/render.h>
#include <nori/scene.h>
#include <statistics/replicates.h>
#include <support/work_folder.h>

#include <filesystem/resolver.h>
#include <gtest/gtest.h>
#include <pugixml.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// Choosing lights by power against choosing them uniformly, on the scene with seven point lights.
// One sample of the light i, chosen with probability p_i, is c_i / p_i, so its variance in a pixel
// is sum E[c_i^2] / p_i - (sum E[c_i])^2 exactly; the expectations over the pixel come from renders
// with one light each, which choose nothing.

namespace {

namespace fs = std::filesystem;
using statistics::MomentSummary;

constexpr int kWidth = 160;
constexpr int kHeight = 120;
constexpr int kSamples = 64;
constexpr std::size_t kChannels = 3;
/// False alarms of a right renderer: 6e-7 over the seeds.
constexpr double kDeviations = 5.0;

/// Values of all channels of all pixels: [pixels * channels].
using Moments = std::vector<MomentSummary>;

/// The scene that ships, to be changed and rendered.
class SceneVariant {
public:
    SceneVariant() {
        const fs::path file =
            fs::path(NORI_SOURCE_DIR) / "scenes" / "assignment-2" / "serapis" / "serapis_ems.xml";
        if (!m_document.load_file(file.c_str()))
            throw std::runtime_error("cannot read " + file.string());
        for (const pugi::xml_node light : root().children("emitter"))
            m_lights.push_back(light);
        nori::getFileResolver()->prepend(filesystem::path(file.parent_path().string()));
    }

    std::size_t lightCount() const { return m_lights.size(); }

    /// Radiance of a light, as the file says: "r, g, b".
    std::array<double, 3> radianceOf(std::size_t light) const {
        std::istringstream text(m_lights[light].child("color").attribute("value").as_string());
        std::array<double, 3> colour{};
        char comma = ' ';
        text >> colour[0] >> comma >> colour[1] >> comma >> colour[2];
        return colour;
    }

    SceneVariant &setRadiances(const char *colour) {
        for (pugi::xml_node light : m_lights)
            light.child("color").attribute("value").set_value(colour);
        return *this;
    }

    SceneVariant &chooseBy(const char *choice) {
        pugi::xml_node property = root().append_child("string");
        property.append_attribute("name").set_value("emitterSampling");
        property.append_attribute("value").set_value(choice);
        return *this;
    }

    SceneVariant &keepOnly(std::size_t light) {
        for (std::size_t i = 0; i < m_lights.size(); ++i) {
            if (i != light)
                root().remove_child(m_lights[i]);
        }
        m_lights = {m_lights[light]};
        return *this;
    }

    Moments render(int seed) const {
        const support::WorkFolder folder;
        const fs::path file = folder.path() / "scene.xml";
        m_document.save_file(file.c_str());
        const std::unique_ptr<nori::NoriObject> object(nori::loadFromXML(
            file.string(), nori::SceneOverrides{nori::Vector2i(kWidth, kHeight), ""}));
        nori::RenderOptions options;
        options.samplesPerPixel = kSamples;
        options.seed = seed;
        options.moments = true;
        Moments all;
        for (const nori::PixelMoments &pixel :
             nori::render(dynamic_cast<nori::Scene &>(*object), options).moments) {
            for (std::size_t c = 0; c < kChannels; ++c)
                all.push_back({pixel.count, pixel.mean.at(c), pixel.variance.at(c), 0.0});
        }
        return all;
    }

private:
    pugi::xml_node root() const { return m_document.document_element(); }

    pugi::xml_document m_document;
    std::vector<pugi::xml_node> m_lights;
};

/// Variances of one sample, summed over pixels and channels, if lights are chosen so.
class Prediction {
public:
    Prediction() {
        const std::size_t count = SceneVariant().lightCount();
        for (std::size_t i = 0; i < count; ++i)
            m_lights.push_back(SceneVariant().keepOnly(i).render(100 + static_cast<int>(i)));
    }

    /// \param probabilities  one per light, sum 1
    double variance(const std::vector<double> &probabilities) const {
        double sum = 0.0;
        for (std::size_t place = 0; place < m_lights.front().size(); ++place) {
            double mean = 0.0;
            double noise = 0.0; ///< of `mean`, which would raise its square
            for (std::size_t i = 0; i < m_lights.size(); ++i) {
                const MomentSummary &light = m_lights[i][place];
                const double square =
                    light.mean * light.mean + light.variance * (light.count - 1) / light.count;
                sum += square / probabilities[i];
                mean += light.mean;
                noise += light.variance / light.count;
            }
            sum -= mean * mean - noise;
        }
        return sum;
    }

private:
    std::vector<Moments> m_lights; ///< alone, each
};

std::vector<double> uniformChoice() {
    const std::size_t count = SceneVariant().lightCount();
    return std::vector<double>(count, 1.0 / static_cast<double>(count));
}

/// In proportion to the luminance of the radiances in the file (ITU-R BT.709).
std::vector<double> choiceByPower() {
    const SceneVariant scene;
    std::vector<double> choice;
    double sum = 0.0;
    for (std::size_t i = 0; i < scene.lightCount(); ++i) {
        const std::array<double, 3> colour = scene.radianceOf(i);
        choice.push_back(0.2126 * colour[0] + 0.7152 * colour[1] + 0.0722 * colour[2]);
        sum += choice.back();
    }
    for (double &probability : choice)
        probability /= sum;
    return choice;
}

TEST(LightChoice, ChangesTheVarianceOfSevenLightsAsPredicted) {
    ASSERT_EQ(SceneVariant().lightCount(), 7u);
    const Moments uniform = SceneVariant().chooseBy("uniform").render(1);
    const Moments power = SceneVariant().chooseBy("power").render(2);
    const statistics::RatioEstimate measured =
        statistics::varianceRatio(uniform, power, {.channels = kChannels});

    const Prediction prediction;
    const double expected =
        prediction.variance(uniformChoice()) / prediction.variance(choiceByPower());
    RecordProperty("measured", std::to_string(measured.ratio));
    RecordProperty("predicted", std::to_string(expected));
    EXPECT_NEAR(measured.ratio, expected, 0.1 * expected);
    EXPECT_NEAR(measured.ratio, expected, kDeviations * measured.standardError);

    // The wrong twins: a choice that claims to go by power, but stays uniform, and one by powers
    // that stand beside the wrong lights.
    const double unchanged =
        statistics::varianceRatio(uniform, SceneVariant().chooseBy("uniform").render(3),
                                  {.channels = kChannels})
            .ratio;
    EXPECT_GT(std::abs(unchanged - expected), kDeviations * measured.standardError);
    std::vector<double> shifted = choiceByPower();
    std::rotate(shifted.begin(), shifted.begin() + 1, shifted.end());
    const double misplaced = prediction.variance(uniformChoice()) / prediction.variance(shifted);
    EXPECT_GT(std::abs(measured.ratio - misplaced), kDeviations * measured.standardError);
}

TEST(LightChoice, ChangesNothingForEqualLights) {
    const char *const colour = "30, 20, 25";
    const Moments uniform = SceneVariant().setRadiances(colour).chooseBy("uniform").render(4);
    const Moments power = SceneVariant().setRadiances(colour).chooseBy("power").render(5);
    const statistics::RatioEstimate ratio =
        statistics::varianceRatio(uniform, power, {.channels = kChannels});
    EXPECT_NEAR(ratio.ratio, 1.0, kDeviations * ratio.standardError);
    EXPECT_LT(kDeviations * ratio.standardError, 0.05) << "too noisy to tell";
}

} // namespace
