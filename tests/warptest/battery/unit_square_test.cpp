// SPDX-License-Identifier: MIT
#include <battery/unit_square.h>
#include <catalog/warp_catalog.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

using battery::Output;

TEST(ToUnitSquare, LeavesOutWhatIsNotInTheDomain) {
    const std::vector<Output> outputs{
        {0.5F, 0.0F, 0.0F}, {2.0F, 0.0F, 0.0F}, {NAN, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}};
    const auto points = battery::toUnitSquare(catalog::requireWarp("disk"), 0.0, outputs);
    EXPECT_EQ(points.total, 4U);
    EXPECT_EQ(points.invalid(), 2U);
    EXPECT_DOUBLE_EQ(points.u[0], 0.25);
    EXPECT_DOUBLE_EQ(points.u[1], 1.0);
}

TEST(ToUnitSquare, SpreadsTheAzimuthOfThePole) {
    const std::vector<Output> poles(1000, Output{0.0F, 0.0F, 1.0F});
    const auto points = battery::toUnitSquare(catalog::requireWarp("sphere"), 0.0, poles);
    EXPECT_EQ(points.poleAtoms, 1000U);
    const auto counts = battery::countCells(points, 1, 10);
    for (const double count : counts) {
        EXPECT_NEAR(count, 100.0, 3.0);
    }
}

TEST(CountCells, PutsTheUpperEdgeIntoTheLastCell) {
    battery::UnitSquarePoints points;
    points.u = {0.0, 0.25, 0.5, 1.0};
    points.v = {0.0, 1.0, 0.49, 1.0};
    points.total = 4;
    EXPECT_EQ(battery::countCells(points, 2, 2), (std::vector<double>{1, 1, 1, 1}));
}
