// SPDX-License-Identifier: MIT
#include <grader/checks/emitter_samples.h>

#include <gtest/gtest.h>

namespace grader {
namespace {

/// Rows of a light of varying density, by one convention.
std::vector<EmitterSampleRow> rowsBy(double (*divisor)(double pdf)) {
    std::vector<EmitterSampleRow> rows;
    for (int i = 1; i <= 1000; ++i) {
        EmitterSampleRow row;
        row.pdf = 0.1 + 0.01 * i;
        row.eval = Vector3d(1, 2, 3);
        row.value = row.eval / divisor(row.pdf);
        rows.push_back(row);
    }
    return rows;
}

TEST(SampleConvention, IsFoundFromTheRows) {
    EXPECT_EQ(detectConvention(rowsBy([](double) { return 1.0; })), SampleConvention::Value);
    EXPECT_EQ(detectConvention(rowsBy([](double pdf) { return pdf; })),
              SampleConvention::ValueOverPdf);
    int wrong = 0;
    EXPECT_EQ(detectConvention(rowsBy([](double pdf) { return pdf * pdf; }), &wrong),
              SampleConvention::Neither);
    EXPECT_GT(wrong, 900);
}

TEST(SampleConvention, MustNotBeMixed) {
    std::vector<EmitterSampleRow> rows = rowsBy([](double) { return 1.0; });
    const std::vector<EmitterSampleRow> others = rowsBy([](double pdf) { return pdf; });
    rows.insert(rows.end(), others.begin(), others.end());
    EXPECT_EQ(detectConvention(rows), SampleConvention::Neither);
}

TEST(SampleConvention, LooksPastDarkRows) {
    std::vector<EmitterSampleRow> rows = rowsBy([](double pdf) { return pdf; });
    for (std::size_t i = 0; i < 500; ++i) {
        rows[i].eval.setZero();
        rows[i].value.setZero();
        rows[i].pdf = 0;
    }
    EXPECT_EQ(detectConvention(rows), SampleConvention::ValueOverPdf);
}

} // namespace
} // namespace grader
