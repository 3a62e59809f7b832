// SPDX-License-Identifier: MIT
#include <statistics/quadrature.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

TEST(IntegrateUnitSquare, IsExactForSmoothFunctions) {
    const auto result =
        statistics::integrateUnitSquare([](double u, double v) { return std::exp(u + 2.0 * v); });
    const double e = std::numbers::e;
    EXPECT_NEAR(result.value, (e - 1.0) * (e * e - 1.0) / 2.0, 1e-12);
    EXPECT_LT(result.errorBound, 1e-12);
}

TEST(IntegrateUnitSquare, OwnsUpToItsErrorAtAStep) {
    const auto result =
        statistics::integrateUnitSquare([](double u, double) { return u < 0.3 ? 1.0 : 0.0; });
    EXPECT_NEAR(result.value, 0.3, 0.03);
    EXPECT_GT(result.errorBound, 1e-4);
}

TEST(GaussNodes, AreTheTabulatedOnes) {
    // Abramowitz & Stegun 25.4.30, n = 4: 0.861136311594053, weight 0.347854845137454.
    const auto nodes = statistics::gaussNodes(4);
    ASSERT_EQ(nodes.size(), 16U);
    double largest = 0.0;
    double total = 0.0;
    for (const auto &node : nodes) {
        largest = std::fmax(largest, node.u);
        total += node.weight;
    }
    EXPECT_NEAR(largest, 0.5 * (1.0 + 0.861136311594053), 1e-15);
    EXPECT_NEAR(total, 1.0, 1e-14);
    EXPECT_THROW(statistics::gaussNodes(5), std::invalid_argument);
    EXPECT_THROW(statistics::integrateNodes(std::vector<double>(7)), std::invalid_argument);
}
