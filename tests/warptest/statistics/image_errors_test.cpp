// SPDX-License-Identifier: MIT
#include <statistics/image_errors.h>
#include <statistics/random.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace statistics {
namespace {

TEST(ImageErrors, MatchTheirFormulas) {
    const std::vector<float> image{1, 2, 5, 0};
    const std::vector<float> reference{1, 1, 3, 1};
    const ImageErrors errors = imageErrors(image, reference);
    EXPECT_DOUBLE_EQ(errors.mean, 2);
    EXPECT_DOUBLE_EQ(errors.referenceMean, 1.5);
    EXPECT_DOUBLE_EQ(errors.rmse, std::sqrt((0 + 1 + 4 + 1) / 4.0));
    const double floor = 1e-2 * 1.5 * 1.5;
    EXPECT_DOUBLE_EQ(errors.relMse, (1 / (1 + floor) + 4 / (9 + floor) + 1 / (1 + floor)) / 4);
    EXPECT_DOUBLE_EQ(errors.smape, (2 / 3.0015 + 4 / 8.0015 + 2 / 1.0015) / 4);
    EXPECT_DOUBLE_EQ(errors.largest, 2);
}

TEST(ImageErrors, AreZeroForEqualImagesEvenBlackOnes) {
    const std::vector<float> black(4, 0.0F);
    const ImageErrors errors = imageErrors(black, black);
    EXPECT_EQ(errors.rmse, 0);
    EXPECT_EQ(errors.relMse, 0);
    EXPECT_EQ(errors.smape, 0);
}

TEST(ImageErrors, NeedImagesOfOneSize) {
    EXPECT_THROW(imageErrors({}, {}), std::invalid_argument);
    EXPECT_THROW(imageErrors(std::vector<float>(2), std::vector<float>(3)), std::invalid_argument);
}

/// Differences of `pixels` pairs of independent means, scaled; their true variances are 1.
std::vector<double> differences(std::size_t pixels, double scale, std::uint64_t seed) {
    Random random(seed);
    std::vector<double> values;
    for (std::size_t i = 0; i < pixels; ++i) {
        double sum = -6; // of 12 uniform numbers: variance 1, nearly normal
        for (int k = 0; k < 12; ++k)
            sum += random.nextDouble();
        values.push_back(scale * sum);
    }
    return values;
}

TEST(NoiseTest, AcceptsIndependentNoiseAndRejectsLessOrMore) {
    // z has deviation 1 under the null: 4.9 is a level of 1e-6. With n pixels a ratio of r moves it
    // by (r - 1) sqrt(n) / (sqrt(2) r): for 4000 and 0.7 or 1.4 about 19 and 13.
    const std::vector<double> variances(4000, 1.0);
    EXPECT_LT(std::fabs(noiseTest(differences(4000, 1, 1), variances).z), 4.9);
    const NoiseTest shared = noiseTest(differences(4000, std::sqrt(0.7), 2), variances);
    EXPECT_LT(shared.z, -4.9);
    EXPECT_NEAR(shared.ratio, 0.7, 0.1);
    EXPECT_GT(noiseTest(differences(4000, std::sqrt(1.4), 3), variances).z, 4.9);
}

TEST(NoiseTest, KeepsItsLevel) {
    // 2000 runs: 20 expected below 0.01, deviation 4.5; 99.9 % limits 6 and 36.
    const std::vector<double> variances(500, 1.0);
    int rejections = 0;
    for (std::uint64_t run = 0; run < 2000; ++run)
        rejections += noiseTest(differences(500, 1, 1000 + run), variances).pValue < 0.01 ? 1 : 0;
    EXPECT_GT(rejections, 6);
    EXPECT_LT(rejections, 36);
}

TEST(NoiseTest, NeedsAVarianceForEachDifference) {
    EXPECT_THROW(noiseTest({}, {}), std::invalid_argument);
    EXPECT_THROW(noiseTest(std::vector<double>(3), std::vector<double>(2)), std::invalid_argument);
}

} // namespace
} // namespace statistics
