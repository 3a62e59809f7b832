// SPDX-License-Identifier: MIT
#include <statistics/random.h>
#include <statistics/stratified_moments.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace {

struct Points {
    std::vector<double> u;
    std::vector<double> v;
};

Points stratified(int side, double exponent) {
    statistics::Random random(9);
    Points points;
    for (int i = 0; i < side; ++i) {
        for (int j = 0; j < side; ++j) {
            const double u = (i + random.nextDouble()) / side;
            points.u.push_back(std::pow(u, exponent));
            points.v.push_back((j + random.nextDouble()) / side);
        }
    }
    return points;
}

} // namespace

TEST(StratifiedMoments, AreTheDefinedOnesForASinglePoint) {
    const std::vector<double> u{0.3};
    const std::vector<double> v{0.2};
    const auto moments = statistics::stratifiedMoments(u, v);
    ASSERT_EQ(moments.values.size(), 90U);
    const double pi = std::numbers::pi;
    // j = 0: cos and sin of k = 1 first; j = 2, k = 3 (sine) at 2 * 13 + 6 - 1.
    EXPECT_NEAR(moments.values[0], std::sqrt(2.0) * std::cos(2.0 * pi * 0.2), 1e-14);
    EXPECT_NEAR(moments.values[1], std::sqrt(2.0) * std::sin(2.0 * pi * 0.2), 1e-14);
    EXPECT_NEAR(moments.values[12], std::sqrt(2.0) * std::cos(pi * 0.3), 1e-14);
    EXPECT_NEAR(moments.values[31], 2.0 * std::cos(2.0 * pi * 0.3) * std::sin(2.0 * pi * 3.0 * 0.2),
                1e-13);
    EXPECT_EQ(moments.maxAbs(), std::fabs(moments.values[moments.indexOfMax()]));
}

TEST(StratifiedMoments, VanishForTheUniformLawAndShowATilt) {
    const Points right = stratified(256, 1.0);
    // Standard deviation of a moment: rms gradient / (side^2 sqrt 12); for j = k = 6 the gradient
    // is pi sqrt(36 + 144) = 42, so 1.9e-4. All 90 stay below 5.5 of them but for 4e-6.
    EXPECT_LT(statistics::stratifiedMoments(right.u, right.v).maxAbs(), 1.0e-3);
    // u^1.01 has its first moment at sqrt2 * 0.0059 = 0.0083 (by quadrature): far beyond.
    const Points wrong = stratified(256, 1.01);
    EXPECT_GT(statistics::stratifiedMoments(wrong.u, wrong.v).maxAbs(), 4e-3);
}

TEST(StratifiedMoments, NeedPoints) {
    const std::vector<double> one{0.5};
    EXPECT_THROW(statistics::stratifiedMoments({}, {}), std::invalid_argument);
    EXPECT_THROW(statistics::stratifiedMoments(one, {}), std::invalid_argument);
}
