// SPDX-License-Identifier: MIT
#include <battery/battery.h>

#include <gtest/gtest.h>

#include <cmath>

#include <bindings/sampler_bindings.h>

using battery::Input;
using battery::Output;
using battery::Status;

namespace {

// Level: triple lock 1e-13. Power: an rms error of 1.7 % is found at 1e-4 with probability 0.999,
// a smooth one of 0.15 % always.
battery::TestOptions options() {
    battery::TestOptions options;
    options.seed = 31;
    options.samples = std::size_t{1} << 19U;
    return options;
}

battery::TestResult test(const bindings::Sampler &sampler) {
    return battery::testOwnDensity(sampler.warp, sampler.density, sampler.chart, options());
}

} // namespace

TEST(EnvironmentSampler, DrawsTheDensityThatItStates) {
    const auto result = test(bindings::environmentSampler());
    EXPECT_TRUE(result.passed()) << result;
    EXPECT_NEAR(result.integral, 1.0, 1e-4);
}

TEST(EnvironmentSampler, IsToldFromWrongTwins) {
    bindings::Sampler turned = bindings::environmentSampler(); // the density looks 6 degrees aside
    turned.density = [right = turned.density](const Output &p) {
        const Output there{std::cos(0.1F) * p.x - std::sin(0.1F) * p.z, p.y,
                           std::sin(0.1F) * p.x + std::cos(0.1F) * p.z};
        return right({&there, 1}).front();
    };
    EXPECT_EQ(test(turned).verdict, Status::Fail);

    bindings::Sampler flat = bindings::environmentSampler(); // squeezed towards the horizon
    flat.warp = [right = flat.warp](const Input &s) {
        const Output p = right({&s, 1}).front();
        const float y = 0.98F * p.y;
        const float scale = std::sqrt((1.0F - y * y) / std::fmax(1e-12F, 1.0F - p.y * p.y));
        return Output{scale * p.x, y, scale * p.z};
    };
    EXPECT_EQ(test(flat).verdict, Status::Fail);

    bindings::Sampler brighter = bindings::environmentSampler(); // not divided by the right sum
    brighter.density = [right = brighter.density](const Output &p) {
        return 1.01F * right({&p, 1}).front();
    };
    EXPECT_EQ(test(brighter).verdict, Status::Fail);
}

TEST(DiffuseSampler, DrawsTheDensityThatItStates) {
    const auto result = test(bindings::diffuseSampler());
    EXPECT_TRUE(result.passed()) << result;
    EXPECT_NEAR(result.integral, 1.0, 1e-4);
}

TEST(DiffuseSampler, IsToldFromAUniformDensity) {
    bindings::Sampler uniform = bindings::diffuseSampler();
    uniform.density = [](const Output &p) {
        return p.z > 0.0F ? 0.15915494F : 0.0F;
    };
    EXPECT_EQ(test(uniform).verdict, Status::Fail);
}
