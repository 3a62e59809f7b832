// SPDX-License-Identifier: MIT
#include <catalog/density_ratio.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace {

std::vector<catalog::RatioSample> samples(double constant, int power) {
    std::vector<catalog::RatioSample> result;
    for (int i = 1; i <= 100; ++i) {
        const double cosTheta = i / 100.0;
        result.push_back({constant * std::pow(cosTheta, power), cosTheta});
    }
    return result;
}

} // namespace

TEST(ExplainRatio, NamesAConstant) {
    const auto law = catalog::explainRatio(samples(std::numbers::pi, 0), 0.0);
    EXPECT_TRUE(law.found);
    EXPECT_EQ(law.cosinePower, 0);
    EXPECT_EQ(law.constantName, "pi");
}

TEST(ExplainRatio, FindsAMissingCosine) {
    const auto law = catalog::explainRatio(samples(1.0, -1), 0.3);
    EXPECT_TRUE(law.found);
    EXPECT_EQ(law.cosinePower, -1);
    EXPECT_EQ(law.constantName, "1");
}

TEST(ExplainRatio, FindsNoLawWhereThereIsNone) {
    auto mixed = samples(1.0, 0);
    for (std::size_t i = 0; i < mixed.size(); i += 3) {
        mixed[i].ratio = 2.0 + 0.01 * static_cast<double>(i);
    }
    EXPECT_FALSE(catalog::explainRatio(mixed, 0.0).found);
    EXPECT_FALSE(catalog::explainRatio({}, 0.0).found);
}

TEST(ConstantName, TellsNeighboursApart) {
    EXPECT_EQ(catalog::constantName(std::numbers::pi / 3.14, 0.0), "pi/3.14");
    EXPECT_EQ(catalog::constantName(1.0, 0.0), "1");
    EXPECT_EQ(catalog::constantName(0.09, 0.3), "alpha^2");
    EXPECT_EQ(catalog::constantName(0.09 * std::numbers::pi, 0.3), "pi * alpha^2");
    EXPECT_EQ(catalog::constantName(1.2345, 0.0), "");
}
