// SPDX-License-Identifier: MIT
#include <battery/inputs.h>
#include <battery/moment_rows.h>
#include <catalog/warp_catalog.h>

#include <gtest/gtest.h>

#include <cmath>

namespace battery {
namespace {

std::vector<MomentRow> rowsOf(const catalog::WarpEntry &truth, double a, double squeeze = 1.0) {
    std::vector<Output> outputs;
    for (const Input &s : randomInputs(std::size_t{1} << 18U, 5)) {
        catalog::Point p = truth.warp({static_cast<double>(s.u), static_cast<double>(s.v)}, a);
        p.x *= squeeze;
        outputs.push_back(toOutput(p));
    }
    return momentRows(truth, a, outputs);
}

// Level: 12 x 6 values of N(0, 1) beyond 5.5: 3e-6. The twin's x² is 2 % off, 17 standard errors.
TEST(MomentRows, AgreeForEveryExactWarpAndNotForASqueezedOne) {
    for (const catalog::WarpEntry &truth : catalog::warpCatalog()) {
        for (const double a : truth.parameters) {
            for (const MomentRow &row : rowsOf(truth, a))
                EXPECT_LT(std::fabs(row.z()), 5.5) << truth.id << " " << a << " " << row.name;
        }
    }
    EXPECT_LT(rowsOf(catalog::requireWarp("disk"), 0.0, 0.99)[2].z(), -5.5);
}

TEST(MomentRows, AreThoseOfAKnownDensity) {
    const std::vector<MomentRow> rows = rowsOf(catalog::requireWarp("cosine_hemisphere"), 0.0);
    ASSERT_EQ(rows.size(), 6U);
    EXPECT_EQ(rows[2].name, "mean of z");
    EXPECT_NEAR(rows[2].expected, 2.0 / 3.0, 1e-5);
    EXPECT_NEAR(rows[5].expected, 0.5, 1e-5);
    EXPECT_NEAR(rows[2].standardError, std::sqrt(1.0 / 18.0) / 512.0, 1e-5);
    EXPECT_EQ(rowsOf(catalog::requireWarp("triangle"), 0.0).size(), 4U);
}

TEST(MomentRows, LeaveOutWhatIsNotFinite) {
    const catalog::WarpEntry &square = catalog::requireWarp("square");
    const std::vector<MomentRow> rows =
        momentRows(square, 0.0, std::vector<Output>{{NAN, 0.0F, 0.0F}, {0.25F, 0.5F, 0.0F}});
    EXPECT_EQ(rows[0].found, 0.25);
    EXPECT_EQ(rows[0].z(), 0.0);
    EXPECT_EQ(momentRows(square, 0.0, {}).size(), 4U);
}

} // namespace
} // namespace battery
