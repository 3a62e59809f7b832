// SPDX-License-Identifier: MIT
#include <battery/density.h>
#include <catalog/warp_catalog.h>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "sample_densities.h"

namespace {

constexpr std::size_t kQueries = 20000;

battery::DensityResult judge(const sample_densities::SampleDensity &sample, double a) {
    const auto &entry = catalog::requireWarp(sample.warpId);
    const auto queries = battery::densityQueries(entry, a, 3, kQueries);
    return battery::judgeDensity(entry, a, queries,
                                 sample_densities::run(sample, queries.points, a));
}

} // namespace

TEST(JudgeDensity, AcceptsRightDensitiesHoweverWritten) {
    for (const auto &sample : sample_densities::kRight) {
        for (const double a : catalog::requireWarp(sample.warpId).parameters) {
            const auto result = judge(sample, a);
            const std::string label = std::string(sample.warpId) + " " + std::string(sample.name) +
                                      " " + std::to_string(a) + " worst " +
                                      std::to_string(result.maxRelativeError);
            EXPECT_EQ(result.wrongAtTarget, 0U) << label;
            EXPECT_EQ(result.wrongInside, 0U) << label;
            EXPECT_EQ(result.nonZeroOutside, 0U) << label;
            EXPECT_EQ(result.wrongAtBoundary, 0U) << label;
            EXPECT_EQ(result.mistake, nullptr) << label;
            EXPECT_GT(result.targetPoints, kQueries / 3) << label;
        }
    }
}

TEST(JudgeDensity, RejectsWrongTwinsAndNamesTheMistake) {
    for (const auto &sample : sample_densities::kWrong) {
        const double a = sample.warpId == "beckmann" ? 0.3 : 0.0;
        const auto result = judge(sample, a);
        const std::string label = std::string(sample.warpId) + " " + std::string(sample.name);
        EXPECT_FALSE(result.rightInside() && result.rightOutside()) << label;
        EXPECT_EQ(result.mistake == nullptr ? "" : result.mistake->id, sample.mistakeId) << label;
        if (!sample.constantName.empty()) {
            EXPECT_EQ(result.ratio.constantName, sample.constantName) << label;
            EXPECT_EQ(result.ratio.cosinePower, sample.cosinePower) << label;
        }
    }
}

TEST(JudgeDensity, MeasuresTheMassOutside) {
    const auto &hemisphere = catalog::requireWarp("hemisphere");
    const auto queries = battery::densityQueries(hemisphere, 0.0, 3, kQueries);
    const std::vector<float> everywhere(queries.points.size(), 0.15915494F);
    const auto result = battery::judgeDensity(hemisphere, 0.0, queries, everywhere);
    EXPECT_NEAR(result.outsideMass, 1.0, 0.05);
    EXPECT_EQ(result.outsideSize, result.outsideMass);
    EXPECT_EQ(result.wrongMass(), 0.0);
    EXPECT_TRUE(result.rightInside());
    EXPECT_FALSE(result.rightOutside());
}

TEST(JudgeDensity, MeasuresWhatIsNegativeOrInfiniteOutside) {
    const auto &hemisphere = catalog::requireWarp("hemisphere");
    const auto queries = battery::densityQueries(hemisphere, 0.0, 3, kQueries);
    for (const float below : {-0.15915494F, INFINITY, NAN}) {
        std::vector<float> pdfs;
        for (const battery::Output &point : queries.points)
            pdfs.push_back(point.z < 0 ? below : 0.15915494F);
        const auto result = battery::judgeDensity(hemisphere, 0.0, queries, pdfs);
        if (std::isfinite(below))
            EXPECT_NEAR(result.outsideSize, 1.0, 0.05);
        else
            EXPECT_EQ(result.outsideSize, INFINITY);
        EXPECT_TRUE(result.rightInside());
    }
}

TEST(JudgeDensity, CountsWhatIsNoDensity) {
    const auto &sphere = catalog::requireWarp("sphere");
    const auto queries = battery::densityQueries(sphere, 0.0, 3, 100);
    std::vector<float> pdfs(queries.points.size(), 0.079577472F);
    pdfs[3] = NAN;
    pdfs[5] = -0.079577472F;
    const auto result = battery::judgeDensity(sphere, 0.0, queries, pdfs);
    EXPECT_EQ(result.notFinite, 1U);
    EXPECT_EQ(result.negative, 1U);
    EXPECT_EQ(result.wrongAtTarget, 2U);
    EXPECT_EQ(result.worst, 3U);
    EXPECT_THROW(battery::judgeDensity(sphere, 0.0, queries, {}), std::invalid_argument);
}
