// SPDX-License-Identifier: MIT
#include <battery/battery.h>
#include <catalog/warp_catalog.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using battery::Input;
using battery::Output;

namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kExponent = 20.0F;

Output atHeight(float z, float turns) {
    const float r = std::sqrt(std::fmax(0.0F, 1.0F - z * z));
    return {r * std::cos(2.0F * kPi * turns), r * std::sin(2.0F * kPi * turns), z};
}

/// The sampler that is tested here: directions in a Phong lobe around +z.
Output sampleLobe(const Input &s) {
    return atHeight(std::pow(1.0F - s.u, 1.0F / (kExponent + 1.0F)), s.v);
}

float lobePdf(const Output &p) {
    return p.z > 0.0F ? (kExponent + 1.0F) / (2.0F * kPi) * std::pow(p.z, kExponent) : 0.0F;
}

/// What is asked for, written down independently of the code above.
float exactLobe(const Output &p) {
    const double z = p.z;
    return z > 0.0 ? static_cast<float>(21.0 / (2.0 * std::numbers::pi) * std::pow(z, 20.0)) : 0.0F;
}

} // namespace

// A target of the catalogue: two lines.
TEST(Disk, IsRight) {
    const auto disk = [](const Input &s) {
        const Output p = atHeight(std::sqrt(1.0F - s.u), s.v);
        return Output{p.x, p.y, 0.0F};
    };
    const auto pdf = [](const Output &p) {
        return p.x * p.x + p.y * p.y <= 1.0F ? 1.0F / kPi : 0.0F;
    };
    const auto result = battery::testWarp(disk, pdf, catalog::requireWarp("disk"));
    EXPECT_TRUE(result.passed()) << result;
}

// A target of one's own: its density, and a chart of the directions that it is on.
TEST(Lobe, IsRight) {
    const auto target = battery::tabulateTarget("lobe", catalog::zone(0.0, 1.0), exactLobe);
    const auto result = battery::testWarp(sampleLobe, lobePdf, target.entry);
    EXPECT_TRUE(result.passed()) << result;
}

// No other truth: do the two agree with each other?
TEST(Lobe, SamplesItsOwnDensity) {
    const auto result =
        battery::testOwnDensity(sampleLobe, lobePdf, catalog::lobe(std::sqrt(2.0 / 20.0)));
    EXPECT_TRUE(result.passed()) << result;
}

// A wrong twin: exponent + 1 forgotten. The result says what is wrong.
TEST(Lobe, IsToldFromAWrongOne) {
    const auto target = battery::tabulateTarget("lobe", catalog::zone(0.0, 1.0), exactLobe);
    const auto wrong = [](const Input &s) {
        return atHeight(std::pow(1.0F - s.u, 1.0F / kExponent), s.v);
    };
    const auto result = battery::testWarp(wrong, lobePdf, target.entry);
    EXPECT_EQ(result.verdict, battery::Status::Fail) << result;
}
