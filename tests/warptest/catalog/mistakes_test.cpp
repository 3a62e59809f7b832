// SPDX-License-Identifier: MIT
#include <catalog/density_mistakes.h>
#include <catalog/warp_catalog.h>
#include <catalog/warp_mistakes.h>
#include <statistics/chi_square.h>
#include <statistics/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace {

constexpr double kAlpha = 0.3; // generic: nothing cancels

template <typename Mistake>
std::string name(const Mistake &mistake) {
    return std::string(mistake.warpId) + "/" + std::string(mistake.id);
}

} // namespace

TEST(WarpMistakes, AreNamedOnceAndExplained) {
    std::set<std::string> names;
    for (const auto &mistake : catalog::warpMistakes()) {
        EXPECT_NE(catalog::findWarp(mistake.warpId), nullptr) << name(mistake);
        EXPECT_TRUE(names.insert(name(mistake)).second) << name(mistake);
        EXPECT_TRUE(mistake.description.ends_with(".")) << name(mistake);
    }
}

TEST(WarpMistakes, AreWrong) {
    // Pearson on 8x8 cells with 2e5 points finds an rms error of 2.4 % at 1e-4, power 0.999.
    constexpr int kSide = 8;
    constexpr double kCount = 2e5;
    for (const auto &mistake : catalog::warpMistakes()) {
        const auto &entry = catalog::requireWarp(mistake.warpId);
        statistics::Random random(1);
        std::vector<double> counts(std::size_t{kSide} * kSide);
        for (int i = 0; i < static_cast<int>(kCount); ++i) {
            catalog::Square s;
            s.u = random.nextDouble();
            s.v = random.nextDouble();
            const catalog::Point p = mistake.warp(s, kAlpha);
            if (catalog::placement(entry, p) == catalog::Placement::Inside) {
                const catalog::Square r = entry.rosenblatt(p, kAlpha);
                const int row = std::clamp(static_cast<int>(r.u * kSide), 0, kSide - 1);
                const int column = std::clamp(static_cast<int>(r.v * kSide), 0, kSide - 1);
                counts[static_cast<std::size_t>(row) * kSide + static_cast<std::size_t>(column)] +=
                    1.0;
            }
        }
        EXPECT_LT(statistics::chiSquareEqualCells(counts, kCount).pValue, 1e-4) << name(mistake);
    }
}

TEST(DensityMistakes, AreNamedOnceExplainedAndWrong) {
    std::set<std::string> names;
    for (const auto &mistake : catalog::densityMistakes()) {
        const auto &entry = catalog::requireWarp(mistake.warpId);
        EXPECT_TRUE(names.insert(name(mistake)).second) << name(mistake);
        EXPECT_TRUE(mistake.description.ends_with(".") || mistake.description.ends_with("?"))
            << name(mistake);
        statistics::Random random(2);
        int wrong = 0;
        for (int i = 0; i < 1000; ++i) {
            catalog::Square s;
            s.u = random.nextDouble();
            s.v = random.nextDouble();
            const catalog::Point p = entry.enlarged(s);
            const double exact = entry.density(p, kAlpha);
            wrong += std::fabs(mistake.density(p, kAlpha) - exact) > 1e-3 * exact + 1e-12 ? 1 : 0;
        }
        EXPECT_GT(wrong, 50) << name(mistake);
    }
}
