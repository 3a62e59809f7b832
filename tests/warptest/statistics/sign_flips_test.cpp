// SPDX-License-Identifier: MIT
#include <statistics/binomial.h>
#include <statistics/random.h>
#include <statistics/sign_flips.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace statistics {
namespace {

/// Products of normal numbers, as of two images' errors.
/// \param shift  added to each factor
/// \param large  each 20th is so many times as large: heavy tails
std::vector<double> products(std::uint64_t seed, double shift, double large) {
    Random random(seed);
    const auto normal = [&] {
        const double u = random.nextDouble();
        const double v = random.nextDouble();
        return std::sqrt(-2 * std::log(1 - u)) * std::cos(6.283185307179586 * v) + shift;
    };
    std::vector<double> values;
    for (int i = 0; i < 100; ++i) {
        const double a = normal();
        const double b = normal();
        values.push_back(a * b * (i % 20 == 0 ? large : 1));
    }
    return values;
}

TEST(SignFlips, CountTheSignsOfAFewValuesExactly) {
    // 3 + 2 + 1 and its negative: 2 of 8; of 1024 flips with a deviation of 0.014 (4.9: 0.07).
    EXPECT_NEAR(signFlipPValue(std::vector<double>{3, 2, 1}, 1), 0.25, 0.07);
    // |3 - 2 + 1| = 2 or more: all but +-(3 - 2 - 1) = 0.
    EXPECT_NEAR(signFlipPValue(std::vector<double>{3, -2, 1}, 1), 0.75, 0.07);
    EXPECT_EQ(signFlipPValue(std::vector<double>(5, 0.0), 1), 1);
    EXPECT_EQ(signFlipPValue({}, 1), 1);
    // 2 of 2^200, which no flip will show: told by the bound, as the smallest that is told.
    EXPECT_EQ(signFlipPValue(std::vector<double>(200, 1.0), 1), std::ldexp(1.0, -20));
}

TEST(SignFlips, KeepTheirLevelUnderHeavyTails) {
    constexpr int kRuns = 4000;
    std::uint64_t below[2] = {0, 0};
    for (std::uint64_t run = 0; run < kRuns; ++run) {
        const double p = signFlipPValue(products(2 * run, 0, 100), 2 * run + 1);
        below[0] += p <= 0.1 ? 1 : 0;
        below[1] += p <= 0.01 ? 1 : 0;
    }
    // Intervals miss with probability 1e-6.
    const Interval often = clopperPearson(below[0], kRuns, 1e-6);
    EXPECT_LE(often.lower, 0.1);
    EXPECT_GE(often.upper, 0.1);
    const Interval seldom = clopperPearson(below[1], kRuns, 1e-6);
    EXPECT_LE(seldom.lower, 0.01);
    EXPECT_GE(seldom.upper, 0.01);
}

TEST(SignFlips, FindWhatIsNotAboutZero) {
    EXPECT_LT(signFlipPValue(products(1, 1, 2), 2), 1e-6);
    EXPECT_EQ(signFlipPValue(products(1, 1, 2), 2), signFlipPValue(products(1, 1, 2), 2));
}

} // namespace
} // namespace statistics
