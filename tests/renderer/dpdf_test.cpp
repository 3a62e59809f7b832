// SPDX-License-Identifier: MIT
#include <nori/dpdf.h>

#include <gtest/gtest.h>

#include <cmath>

namespace nori {
namespace {

DiscretePDF distribution(const std::vector<float> &weights) {
    DiscretePDF result(weights.size());
    for (const float weight : weights)
        result.append(weight);
    result.normalize();
    return result;
}

TEST(DiscretePDF, TurnsWeightsIntoProbabilities) {
    DiscretePDF pdf;
    pdf.append(1.0f);
    pdf.append(3.0f);
    EXPECT_EQ(pdf.size(), 2u);
    EXPECT_FLOAT_EQ(pdf[1], 3.0f);
    EXPECT_FALSE(pdf.isNormalized());

    EXPECT_FLOAT_EQ(pdf.normalize(), 4.0f);

    EXPECT_TRUE(pdf.isNormalized());
    EXPECT_FLOAT_EQ(pdf.getSum(), 4.0f);
    EXPECT_FLOAT_EQ(pdf.getNormalization(), 0.25f);
    EXPECT_FLOAT_EQ(pdf[0], 0.25f);
    EXPECT_FLOAT_EQ(pdf[1], 0.75f);
}

TEST(DiscretePDF, ChangesEntryJustAfterAPartialSum) {
    const DiscretePDF pdf = distribution({1, 1, 2});

    const struct {
        float u;
        size_t entry;
    } rows[] = {{0.0f, 0},
                {std::nextafter(0.25f, 0.0f), 0},
                {0.25f, 0},
                {std::nextafter(0.25f, 1.0f), 1},
                {0.5f, 1},
                {std::nextafter(0.5f, 1.0f), 2},
                {std::nextafter(1.0f, 0.0f), 2},
                {1.0f, 2}};

    for (const auto &row : rows) {
        float probability = 0.0f;
        EXPECT_EQ(pdf.sample(row.u), row.entry) << row.u;
        EXPECT_EQ(pdf.sample(row.u, probability), row.entry) << row.u;
        EXPECT_FLOAT_EQ(probability, pdf[row.entry]) << row.u;
    }
}

TEST(DiscretePDF, NeverDrawsAnImpossibleEntryExceptTheFirstAtZero) {
    const DiscretePDF pdf = distribution({0, 1, 0, 1, 0});
    EXPECT_EQ(pdf.sample(0.0f), 0u); // as in Nori: whoever samples has to know
    for (const float u : {1e-30f, 0.3f, 0.5f, 0.7f, 1.0f - 0x1p-24f}) {
        const size_t entry = pdf.sample(u);
        EXPECT_TRUE(entry == 1 || entry == 3) << u;
    }
}

TEST(DiscretePDF, ReusesTheNumberItWasGiven) {
    const DiscretePDF pdf = distribution({1, 3});
    float u = 0.25f + 0.75f * 0.5f;
    float probability = 0.0f;
    EXPECT_EQ(pdf.sampleReuse(u, probability), 1u);
    EXPECT_FLOAT_EQ(u, 0.5f);
    EXPECT_FLOAT_EQ(probability, 0.75f);
    u = 0.125f;
    EXPECT_EQ(pdf.sampleReuse(u), 0u);
    EXPECT_FLOAT_EQ(u, 0.5f);
}

TEST(DiscretePDF, IsSafeWhenEmptyOrWithoutWeight) {
    DiscretePDF pdf;
    float u = 0.5f;
    float probability = 1.0f;
    EXPECT_EQ(pdf.sample(u), 0u);
    EXPECT_EQ(pdf.sampleReuse(u, probability), 0u);
    EXPECT_EQ(probability, 0.0f);
    EXPECT_EQ(u, 0.5f);
    EXPECT_FALSE(pdf.toString().empty());

    pdf.append(0.0f);
    EXPECT_EQ(pdf.normalize(), 0.0f);
    EXPECT_FALSE(pdf.isNormalized());
    EXPECT_EQ(pdf.getNormalization(), 0.0f);
}

TEST(DiscretePDF, StartsAnewAfterClear) {
    DiscretePDF pdf = distribution({1, 3});
    pdf.clear();
    EXPECT_EQ(pdf.size(), 0u);
    EXPECT_FALSE(pdf.isNormalized());
}

} // namespace
} // namespace nori
