// SPDX-License-Identifier: MIT
#include <battery/battery.h>
#include <catalog/warp_catalog.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "sample_warps.h"

using battery::Input;
using battery::Output;
using battery::Status;

namespace {

constexpr double kPi = std::numbers::pi;

battery::TestOptions options() {
    battery::TestOptions options;
    options.seed = 21;
    options.samples = std::size_t{1} << 19U;
    return options;
}

/// A lobe cos^n around +z, as in Phong's model.
Output lobe(const Input &s, float n) {
    return sample_warps::atHeight(std::pow(s.u, 1.0F / (n + 1.0F)), 2.0F * sample_warps::kPi * s.v);
}

float lobePdf(const Output &p) {
    return p.z > 0.0F ? 6.0F / (2.0F * sample_warps::kPi) * std::pow(p.z, 5.0F) : 0.0F;
}

float beckmannPdf(const Output &p) {
    static const auto &truth = catalog::requireWarp("beckmann");
    return static_cast<float>(truth.density(battery::toPoint(p), 0.05));
}

Output beckmann(const Input &s, float alpha) {
    return sample_warps::ofTangent(-alpha * alpha * std::log(1.0F - s.u),
                                   2.0F * sample_warps::kPi * s.v);
}

} // namespace

TEST(TabulateTarget, FindsTheDistributionFunctionOfACataloguedWarp) {
    const auto &truth = catalog::requireWarp("cosine_hemisphere");
    const auto target =
        battery::tabulateTarget("cosine", catalog::zone(0.0, 1.0), [&](const Output &p) {
            return static_cast<float>(3.0 * truth.density(battery::toPoint(p), 0.0));
        });
    EXPECT_TRUE(target.isReliable());
    EXPECT_NEAR(target.integral, 3.0, 1e-5);
    EXPECT_NEAR(target.checkIntegral, 3.0, 1e-3);
    for (const Input &s : battery::randomInputs(2000, 3)) {
        const catalog::Square at{static_cast<double>(s.u), static_cast<double>(s.v)};
        const catalog::Point p = target.entry.warp(at, 0.0);
        const catalog::Square back = target.entry.rosenblatt(p, 0.0);
        EXPECT_NEAR(back.u, at.u, 1e-9);
        EXPECT_NEAR(back.v, at.v, 1e-9);
        EXPECT_NEAR(p.z * p.z, at.u, 1e-5); // the zone's u goes along the cosine
        EXPECT_NEAR(target.entry.density(p, 0.0), p.z / kPi, 1e-5);
    }
    EXPECT_EQ(target.entry.density({0.0, 0.6, -0.8}, 0.0), 0.0);
}

TEST(TabulateTarget, RefinesCellsThatAJumpRunsThrough) {
    // a disk in its square: the jump follows no grid
    const auto target = battery::tabulateTarget(
        "disk", catalog::rectangle({-1.0, -1.0, 0.0}, {1.0, 1.0, 0.0}),
        [](const Output &p) { return p.x * p.x + p.y * p.y <= 1.0F ? 1.0F : 0.0F; });
    EXPECT_NEAR(target.integral, kPi, 1e-4);
    EXPECT_TRUE(target.isReliable());
}

TEST(TabulateTarget, RefusesADensityThatIsZero) {
    EXPECT_THROW(battery::tabulateTarget("zero", catalog::zone(0.0, 1.0),
                                         [](const Output &) { return 0.0F; }),
                 std::invalid_argument);
}

// Level: triple lock 1e-13. Power: an rms error of 1.7 % is found at 1e-4 with probability 0.999.
TEST(TestWarp, TakesATargetOfOnesOwn) {
    const auto target = battery::tabulateTarget("lobe", catalog::zone(0.0, 1.0), lobePdf);
    const auto right = battery::testWarp([](const Input &s) { return lobe(s, 5.0F); }, lobePdf,
                                         target.entry, options());
    EXPECT_TRUE(right.passed()) << right;
    const auto wrong = battery::testWarp([](const Input &s) { return lobe(s, 5.1F); }, lobePdf,
                                         target.entry, options());
    EXPECT_EQ(wrong.verdict, Status::Fail) << wrong;
    const auto wrongPdf = battery::testWarp([](const Input &s) { return lobe(s, 5.0F); },
                                            [](const Output &p) { return 1.01F * lobePdf(p); },
                                            target.entry, options());
    EXPECT_EQ(wrongPdf.verdict, Status::Fail) << wrongPdf;
}

TEST(TestOwnDensity, PassesAWarpThatSamplesIt) {
    const auto result = battery::testOwnDensity([](const Input &s) { return beckmann(s, 0.05F); },
                                                beckmannPdf, catalog::lobe(0.05), options());
    EXPECT_TRUE(result.passed()) << result;
}

TEST(TestOwnDensity, FailsAWarpThatSamplesAnother) {
    const auto result = battery::testOwnDensity([](const Input &s) { return beckmann(s, 0.0505F); },
                                                beckmannPdf, catalog::lobe(0.05), options());
    EXPECT_EQ(result.verdict, Status::Fail) << result;
}

TEST(TestOwnDensity, FailsADensityThatIsNotNormalised) {
    const auto result = battery::testOwnDensity(
        [](const Input &s) { return beckmann(s, 0.05F); },
        [](const Output &p) { return 1.01F * beckmannPdf(p); }, catalog::lobe(0.05), options());
    EXPECT_EQ(result.verdict, Status::Fail) << result;
    EXPECT_NEAR(result.integral, 1.01, 1e-3);
}

TEST(TestOwnDensity, CannotTellWhereThePeakIsMissed) {
    // A third of the mass in a peak that lies between the points of the table.
    constexpr float kPlace = 0.50003F;
    constexpr float kWidth = 1e-5F;
    const auto inPeak = [](const Output &p) {
        return p.x >= kPlace && p.x < kPlace + kWidth && p.y >= kPlace && p.y < kPlace + kWidth;
    };
    const auto result = battery::testOwnDensity(
        [=](const Input &s) {
            return s.u < 1.0F / 3.0F
                       ? Output{kPlace + kWidth * 3.0F * s.u, kPlace + kWidth * s.v, 0.0F}
                       : Output{1.5F * (s.u - 1.0F / 3.0F), s.v, 0.0F};
        },
        [=](const Output &p) { return inPeak(p) ? 1.0F / (3.0F * kWidth * kWidth) : 2.0F / 3.0F; },
        catalog::rectangle({0.0, 0.0, 0.0}, {1.0, 1.0, 0.0}), options());
    EXPECT_EQ(result.verdict, Status::Inconclusive) << result;
    EXPECT_NEAR(result.integral, 2.0 / 3.0, 1e-3);
    EXPECT_NEAR(result.importance.mean, 2.0 / 3.0, 0.01);
}

TEST(TestOwnDensity, CannotTellWhereTwoRulesDiffer) {
    // Needles that lie on the midpoints of the second rule and between the points of the first.
    const auto result = battery::testOwnDensity(
        [](const Input &s) {
            return Output{s.u, s.v, 0.0F};
        },
        [](const Output &p) {
            const float phase = 3.0F * battery::kTableSide * p.x;
            return std::fabs(phase - std::floor(phase) - 0.5F) < 0.01F ? 2.0F : 1.0F;
        },
        catalog::rectangle({0.0, 0.0, 0.0}, {1.0, 1.0, 0.0}), options());
    EXPECT_EQ(result.verdict, Status::Inconclusive) << result;
    const auto row = std::find_if(result.rows.begin(), result.rows.end(),
                                  [](const auto &r) { return r.id == "integration"; });
    ASSERT_NE(row, result.rows.end());
    EXPECT_EQ(row->status, Status::Inconclusive) << result;
}

TEST(TestOwnDensity, ShowsADensityThatThrows) {
    const auto result = battery::testOwnDensity(
        [](const Input &s) { return lobe(s, 5.0F); },
        [](const Output &) -> float { throw std::runtime_error("not implemented yet"); },
        catalog::zone(0.0, 1.0), options());
    EXPECT_EQ(result.verdict, Status::Fail);
    EXPECT_EQ(result.error, "not implemented yet");
}
