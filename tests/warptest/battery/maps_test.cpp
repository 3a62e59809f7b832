// SPDX-License-Identifier: MIT
#include <battery/inputs.h>
#include <battery/maps.h>
#include <catalog/warp_catalog.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace battery {
namespace {

double sum(const std::vector<double> &values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Outputs of the exact warp.
std::vector<Output> exactOutputs(const catalog::WarpEntry &truth, double a, std::size_t count) {
    std::vector<Output> outputs;
    for (const Input &input : randomInputs(count, 1))
        outputs.push_back(
            toOutput(truth.warp({static_cast<double>(input.u), static_cast<double>(input.v)}, a)));
    return outputs;
}

class EveryWarp : public testing::TestWithParam<std::string> {};

TEST_P(EveryWarp, HasAMapThatHoldsItsWholeDensity) {
    const catalog::WarpEntry &truth = catalog::requireWarp(GetParam());
    for (const double a : truth.parameters) {
        const Maps maps = makeMaps(truth, a, exactOutputs(truth, a, 20000));
        EXPECT_EQ(maps.outside, 0U);
        EXPECT_EQ(sum(maps.observed), 20000.0);
        // midpoints on a curved boundary miss a little of the cells that it cuts
        EXPECT_NEAR(sum(maps.expected), 20000.0, 100.0) << "a = " << a;
    }
}

/// Level 1e-6: a sum of squares of n standardised residuals exceeds n + 7 sqrt(2 n) less often.
TEST_P(EveryWarp, HasResidualsOfSizeOneWhereItIsRight) {
    const catalog::WarpEntry &truth = catalog::requireWarp(GetParam());
    const double a = truth.parameters.front();
    const auto squares = [&](const catalog::WarpEntry &expected) {
        const Maps maps = makeMaps(expected, a, exactOutputs(truth, a, 200000));
        double total = 0.0;
        for (const double residual : maps.residual)
            total += residual * residual;
        const auto n =
            static_cast<double>(std::count(maps.sparse.begin(), maps.sparse.end(), false));
        return (total - n) / std::sqrt(2.0 * n);
    };
    EXPECT_LT(squares(truth), 7.0);
    catalog::WarpEntry twin = truth;
    twin.formula = [&truth](const catalog::Point &p, double b) {
        return 0.9 * truth.formula(p, b);
    };
    EXPECT_GT(squares(twin), 7.0);
}

INSTANTIATE_TEST_SUITE_P(Catalog, EveryWarp,
                         testing::Values("square", "tent", "disk", "triangle", "sphere",
                                         "hemisphere", "cosine_hemisphere", "beckmann"));

TEST(DomainMap, FindsThePointOfAPlaceAndThePlaceOfAPoint) {
    const DomainMap sphere = makeDomainMap(catalog::requireWarp("sphere"));
    EXPECT_NEAR(sphere.measure(), 4.0 * std::numbers::pi, 1e-12);
    const catalog::Point p = sphere.point({0.75, 0.25});
    EXPECT_NEAR(p.y, std::sqrt(0.75), 1e-12); // phi = pi / 2, cos(theta) = -1/2
    EXPECT_NEAR(p.z, -0.5, 1e-12);
    EXPECT_NEAR(sphere.place(p)[0], 0.75, 1e-12);
    EXPECT_NEAR(sphere.place(p)[1], 0.25, 1e-12);
}

TEST(CellAt, CountsTheUpperEdgeInAndWhatIsOutsideOut) {
    EXPECT_EQ(cellAt({0.0, 0.0}, 4), 0);
    EXPECT_EQ(cellAt({0.3, 0.6}, 4), 9);
    EXPECT_EQ(cellAt({1.0, 1.0}, 4), 15);
    EXPECT_EQ(cellAt({1.01, 0.5}, 4), -1);
    EXPECT_EQ(cellAt({0.5, -0.01}, 4), -1);
    EXPECT_EQ(cellAt({std::numeric_limits<double>::quiet_NaN(), 0.5}, 4), -1);
}

TEST(MapsOfCounts, RefusesCountsThatAreNoSquare) {
    const catalog::WarpEntry &square = catalog::requireWarp("square");
    EXPECT_THROW(mapsOfCounts(square, 0.0, std::vector<double>(15, 1.0), 15),
                 std::invalid_argument);
    EXPECT_THROW(mapsOfCounts(square, 0.0, {}, 0), std::invalid_argument);
    EXPECT_EQ(mapsOfCounts(square, 0.0, std::vector<double>(16, 10.0), 200).outside, 40U);
}

TEST(MapsOfCounts, SaysNothingOfCellsInWhichFewAreExpected) {
    std::vector<double> counts(16, 0.0);
    counts[3] = 25.0;
    const Maps maps = mapsOfCounts(catalog::requireWarp("square"), 0.0, counts, 32); // 2 a cell
    EXPECT_TRUE(maps.sparse[0]);
    EXPECT_EQ(maps.residual[0], 0.0);
    EXPECT_FALSE(maps.sparse[3]) << "25 where 2 are expected says something";
    EXPECT_NEAR(maps.residual[3], 23.0 / std::sqrt(5.0), 1e-9);
}

TEST(WorstCell, IsTheFarthestOffToEitherSide) {
    const auto worstOf = [](const std::vector<double> &counts) {
        return worstCell(mapsOfCounts(catalog::requireWarp("square"), 0.0, counts, 160));
    };
    std::vector<double> counts(16, 10.0);
    counts[6] = 17.0;
    EXPECT_EQ(worstOf(counts), 6U);
    counts[9] = 0.0;
    EXPECT_EQ(worstOf(counts), 9U);
    EXPECT_EQ(worstCell({}), 0U);
}

} // namespace
} // namespace battery
