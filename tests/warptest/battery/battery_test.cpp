// SPDX-License-Identifier: MIT
#include <battery/battery.h>
#include <catalog/warp_catalog.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "sample_densities.h"
#include "sample_warps.h"

using battery::Input;
using battery::Output;
using battery::Status;

namespace {

battery::TestOptions few() {
    battery::TestOptions options;
    options.samples = std::size_t{1} << 18U; // an rms error of 2.4 % is found at 1e-4, power 0.999
    options.seed = 11;
    return options;
}

Output disk(const Input &s) {
    return sample_warps::polar(std::sqrt(s.u), 2.0F * sample_warps::kPi * s.v, 0.0F);
}

float diskPdf(const Output &p) {
    return p.x * p.x + p.y * p.y <= 1.0F ? sample_densities::kInvPi : 0.0F;
}

const catalog::WarpEntry &target() {
    return catalog::requireWarp("disk");
}

Status statusOf(const battery::TestResult &result, std::string_view id) {
    const auto row = std::find_if(result.rows.begin(), result.rows.end(),
                                  [=](const auto &r) { return r.id == id; });
    return row == result.rows.end() ? Status::NotRun : row->status;
}

} // namespace

// Level: triple lock 1e-13; the other steps have no level.
TEST(TestWarp, PassesARightWarpWithItsDensity) {
    auto options = few();
    options.samples = battery::kDistributionSamples;
    const auto result = battery::testWarp(disk, diskPdf, target(), options);
    EXPECT_TRUE(result.passed()) << result;
    EXPECT_NEAR(result.integral, 1.0, 1e-5);
    EXPECT_EQ(result.distribution.counts.size(), 1024U);
    EXPECT_EQ(result.repeats, std::vector<Status>{Status::Pass});
}

TEST(TestWarp, CannotTellFromTooFewPoints) {
    auto options = few();
    options.samples = 4096;
    EXPECT_EQ(battery::testWarp(disk, diskPdf, target(), options).verdict, Status::Inconclusive);
}

TEST(TestWarp, FailsAWrongWarpAndNamesTheMistake) {
    const auto result = battery::testWarp(
        [](const Input &s) {
            return sample_warps::polar(s.u, 2.0F * sample_warps::kPi * s.v, 0.0F);
        },
        diskPdf, target(), few());
    EXPECT_EQ(result.verdict, Status::Fail);
    ASSERT_NE(result.mistake.mistake, nullptr);
    EXPECT_EQ(result.mistake.mistake->id, "missing_sqrt");
    EXPECT_EQ(statusOf(result, "pdf_inside"), Status::Pass);
    EXPECT_EQ(statusOf(result, "distribution"), Status::Fail);
    std::ostringstream text;
    text << result;
    EXPECT_NE(text.str().find("square root"), std::string::npos) << text.str();
}

TEST(TestWarp, FailsAWrongDensityAndNamesItsFactor) {
    const auto result = battery::testWarp(
        disk, [](const Output &p) { return 2.0F * diskPdf(p); }, target(), few());
    EXPECT_EQ(statusOf(result, "distribution"), statusOf(result, "histogram"));
    EXPECT_EQ(statusOf(result, "normalisation"), Status::Fail);
    EXPECT_NE(battery::explain(result).find("The density is 2 times the right one."),
              std::string::npos)
        << result;
}

TEST(TestWarp, SaysThatTwoWrongsAgree) {
    const auto &hemisphere = catalog::requireWarp("hemisphere");
    const auto result = battery::testWarp(
        [](const Input &s) { return sample_warps::lifted(sample_warps::concentric(s)); },
        [](const Output &p) { return std::max(0.0F, p.z) * sample_densities::kInvPi; }, hemisphere,
        few());
    EXPECT_EQ(result.verdict, Status::Fail);
    EXPECT_TRUE(result.consistency.consistent());
    EXPECT_NE(battery::explain(result).find("agree with each other"), std::string::npos) << result;
}

TEST(TestWarp, FindsAWarpThatIsNoFunction) {
    unsigned calls = 0;
    const auto result = battery::testWarp(
        [&](const Input &s) {
            return ++calls % 2 == 0 ? disk(s) : disk({1.0F - s.u, s.v});
        },
        diskPdf, target(), few());
    EXPECT_EQ(statusOf(result, "repeatable"), Status::Fail);
}

TEST(TestWarp, FindsTheOneSampleThatGivesNoNumber) {
    for (const auto &sample : sample_warps::kNotFinite) {
        const auto &truth = catalog::requireWarp(sample.warpId);
        const auto result = battery::testWarp([&](const Input &s) { return sample.warp(s, 0.01F); },
                                              [&](const Output &p) {
                                                  return static_cast<float>(
                                                      truth.density(battery::toPoint(p), 0.01));
                                              },
                                              truth, few());
        EXPECT_EQ(statusOf(result, "finite"), Status::Fail) << sample.name << result;
    }
}

TEST(TestWarp, AsksTheDensityWhereTheWarpRounds) {
    // 0.04 % of the samples: 26 are expected among those that are asked
    for (const auto &sample : sample_densities::kWrongAtRounding) {
        const auto result = battery::testWarp(
            [](const Input &s) {
                return sample_warps::atHeight(1.0F - 2.0F * s.u, 2.0F * sample_warps::kPi * s.v);
            },
            [&](const Output &p) { return sample.density(p, 0.0F); },
            catalog::requireWarp(sample.warpId), few());
        EXPECT_EQ(statusOf(result, "pdf_at_samples"), Status::Fail) << sample.name << result;
    }
}

TEST(TestWarp, TakesFunctionsOfManyPointsToo) {
    const auto one = battery::testWarp(disk, diskPdf, target(), few());
    const auto many = battery::testWarp(
        [](std::span<const Input> inputs) {
            std::vector<Output> outputs;
            std::transform(inputs.begin(), inputs.end(), std::back_inserter(outputs), disk);
            return outputs;
        },
        diskPdf, target(), few());
    EXPECT_EQ(one.distribution.counts, many.distribution.counts);
    EXPECT_EQ(battery::explain(one), battery::explain(many));
}

TEST(TestWarp, ShowsWhatTheWarpThrew) {
    const auto thrown = battery::testWarp(
        [](const Input &) -> Output { throw std::runtime_error("not implemented yet"); }, diskPdf,
        target(), few());
    EXPECT_EQ(thrown.verdict, Status::Fail);
    EXPECT_EQ(thrown.error, "not implemented yet");
    const auto short_ = battery::testWarp(
        disk, [](std::span<const Output>) { return std::vector<float>{}; }, target(), few());
    EXPECT_NE(short_.error.find("the density gave 0 answers"), std::string::npos) << short_;
}

TEST(TestWarp, RepeatsWithFreshNumbersAndTellsTheWorst) {
    auto options = few();
    options.repeats = 3;
    int calls = 0; // wrong in the second repeat alone
    options.progress = [&](double fraction) {
        calls = static_cast<int>(fraction * 3.0);
    };
    const auto result = battery::testWarp(
        [&](const Input &s) {
            return calls == 1 ? disk({s.u * s.u, s.v}) : disk(s);
        },
        diskPdf, target(), options);
    EXPECT_EQ(result.verdict, Status::Fail);
    ASSERT_EQ(result.repeats.size(), 3U);
    EXPECT_EQ(result.repeats[1], Status::Fail);
    EXPECT_NE(result.repeats[0], Status::Fail);
    EXPECT_NE(result.repeats[2], Status::Fail);
    EXPECT_EQ(statusOf(result, "repeats"), Status::Fail);
}

TEST(TestWarp, EndsWhenItIsCancelled) {
    auto options = few();
    double reached = 0.0;
    options.progress = [&](double fraction) {
        reached = fraction;
    };
    options.isCancelled = [&] {
        return reached >= 0.3;
    };
    const auto result = battery::testWarp(disk, diskPdf, target(), options);
    EXPECT_EQ(result.verdict, Status::NotRun);
    EXPECT_TRUE(result.rows.empty());
    EXPECT_LT(reached, 0.5);
}

TEST(TestWarp, RejectsOptionsThatMakeNoTest) {
    auto options = few();
    options.samples = 0;
    EXPECT_THROW(battery::testWarp(disk, diskPdf, target(), options), std::invalid_argument);
    options = few();
    options.repeats = 0;
    EXPECT_THROW(battery::testWarp(disk, diskPdf, target(), options), std::invalid_argument);
    options = few();
    options.significance = 0.0;
    EXPECT_THROW(battery::testWarp(disk, diskPdf, target(), options), std::invalid_argument);
}

TEST(TestEveryParameter, FindsWhatOneParameterHides) {
    const auto &beckmann = catalog::requireWarp("beckmann");
    const battery::WarpFamily family{
        [](std::span<const Input> inputs, double a) { // alpha is not squared: right at 1
            std::vector<Output> outputs;
            for (const Input &s : inputs) {
                const auto alpha = static_cast<float>(a);
                outputs.push_back(sample_warps::ofTangent(-alpha * std::log(1.0F - s.u),
                                                          2.0F * sample_warps::kPi * s.v));
            }
            return outputs;
        },
        [&](std::span<const Output> points, double a) {
            std::vector<float> pdfs;
            for (const Output &p : points) {
                pdfs.push_back(static_cast<float>(beckmann.density(battery::toPoint(p), a)));
            }
            return pdfs;
        }};
    const auto results = battery::testEveryParameter(family, beckmann, few());
    ASSERT_EQ(results.size(), 5U);
    for (const auto &result : results) {
        EXPECT_EQ(result.verdict == Status::Fail, result.parameter < 1.0) << result;
    }
}
