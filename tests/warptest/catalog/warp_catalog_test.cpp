// SPDX-License-Identifier: MIT
#include <catalog/warp_catalog.h>
#include <statistics/quadrature.h>
#include <statistics/random.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>
#include <string>

using catalog::Placement;
using catalog::Point;
using catalog::Square;
using catalog::WarpEntry;

namespace {

constexpr int kPoints = 2000;

Square draw(statistics::Random &random) {
    Square s;
    s.u = random.nextDouble();
    s.v = random.nextDouble();
    return s;
}

/// |dx/du x dx/dv| of the exact warp by central differences: area of the image of a unit of (u, v).
double stretch(const WarpEntry &entry, const Square &s, double a) {
    const double h = 1e-5;
    const Point u0 = entry.warp({s.u - h, s.v}, a);
    const Point u1 = entry.warp({s.u + h, s.v}, a);
    const Point v0 = entry.warp({s.u, s.v - h}, a);
    const Point v1 = entry.warp({s.u, s.v + h}, a);
    const Point du{u1.x - u0.x, u1.y - u0.y, u1.z - u0.z};
    const Point dv{v1.x - v0.x, v1.y - v0.y, v1.z - v0.z};
    return std::hypot(du.y * dv.z - du.z * dv.y, du.z * dv.x - du.x * dv.z,
                      du.x * dv.y - du.y * dv.x) /
           (4.0 * h * h);
}

class EveryWarp : public testing::TestWithParam<std::string> {
protected:
    [[nodiscard]] static const WarpEntry &entry() { return catalog::requireWarp(GetParam()); }
};

} // namespace

TEST_P(EveryWarp, HasARosenblattMapThatInvertsItsExactWarp) {
    statistics::Random random(1);
    for (const double a : entry().parameters) {
        for (int i = 0; i < kPoints; ++i) {
            const Square s = draw(random);
            const Square back = entry().rosenblatt(entry().warp(s, a), a);
            ASSERT_NEAR(back.u, s.u, 1e-10) << "a = " << a << ", v = " << s.v;
            ASSERT_NEAR(back.v, s.v, 1e-10) << "a = " << a << ", u = " << s.u;
        }
    }
}

TEST_P(EveryWarp, HasTheDensityOfItsExactWarp) {
    statistics::Random random(2);
    for (const double a : entry().parameters) {
        for (int i = 0; i < kPoints; ++i) {
            Square s = draw(random);
            s = {0.01 + 0.98 * s.u, 0.01 + 0.98 * s.v};
            if (entry().id == "tent" &&
                (std::fabs(s.u - 0.5) < 1e-4 || std::fabs(s.v - 0.5) < 1e-4)) {
                continue; // the crease: no derivative
            }
            const double density = entry().density(entry().warp(s, a), a);
            ASSERT_NEAR(density * stretch(entry(), s, a), 1.0, 1e-4)
                << "a = " << a << " at " << s.u << ", " << s.v;
        }
    }
}

TEST_P(EveryWarp, MapsIntoItsSupportAndKnowsWhatIsOutside) {
    statistics::Random random(3);
    int outside = 0;
    for (int i = 0; i < kPoints; ++i) {
        const double a = entry().parameters.back();
        const Point p = entry().warp(draw(random), a);
        ASSERT_EQ(catalog::placement(entry(), p), Placement::Inside);
        ASSERT_GT(entry().density(p, a), 0.0);
        const Point q = entry().enlarged(draw(random));
        if (entry().margin(q) < 0.0) {
            ++outside;
            ASSERT_EQ(entry().density(q, a), 0.0);
        }
    }
    EXPECT_EQ(outside > 0, entry().boundary != nullptr);
    EXPECT_EQ(catalog::placement(entry(), {NAN, 0.0, 1.0}), Placement::NotFinite);
}

TEST_P(EveryWarp, HasABoundaryOfMarginZero) {
    for (int i = 0; entry().boundary != nullptr && i < 100; ++i) {
        EXPECT_NEAR(entry().margin(entry().boundary(i / 100.0)), 0.0, 1e-12);
    }
}

TEST_P(EveryWarp, KeepsItsDensityUnderTheSymmetriesOfItsDomain) {
    statistics::Random random(4);
    for (int k = 0; k < catalog::symmetryCount(entry()); ++k) {
        const double a = entry().parameters.back();
        const Point p = entry().warp(draw(random), a);
        const Point moved = catalog::symmetry(entry(), p, k);
        EXPECT_NEAR(entry().density(moved, a), entry().density(p, a), 1e-12) << "symmetry " << k;
    }
    const Point p = entry().warp({0.3, 0.2}, 1.0);
    EXPECT_EQ(catalog::symmetry(entry(), p, 0).x, p.x);
}

INSTANTIATE_TEST_SUITE_P(Catalog, EveryWarp,
                         testing::Values("square", "tent", "disk", "triangle", "sphere",
                                         "hemisphere", "cosine_hemisphere", "beckmann"),
                         [](const auto &warp) { return warp.param; });

TEST(WarpCatalog, NamesWhatItKnows) {
    EXPECT_EQ(catalog::warpCatalog().size(), 8U);
    EXPECT_EQ(catalog::findWarp("cube"), nullptr);
    try {
        catalog::requireWarp("cube");
        FAIL() << "no exception";
    } catch (const std::invalid_argument &error) {
        EXPECT_STREQ(error.what(), "unknown warp \"cube\"; known: square tent disk triangle sphere "
                                   "hemisphere cosine_hemisphere beckmann");
    }
}

TEST(WarpCatalog, KnowsDirectionsThatAreNotUnitLength) {
    const WarpEntry &sphere = catalog::requireWarp("sphere");
    EXPECT_EQ(catalog::placement(sphere, {0.0, 0.0, 1.0001}), Placement::OffNorm);
    EXPECT_EQ(catalog::placement(sphere, {0.0, 0.0, 1.000001}), Placement::Inside);
    EXPECT_EQ(catalog::placement(catalog::requireWarp("hemisphere"), {0.6, 0.0, -0.8}),
              Placement::Outside);
}

TEST(WarpCatalog, WidensTolerancesByConditioning) {
    const WarpEntry &beckmann = catalog::requireWarp("beckmann");
    const WarpEntry &disk = catalog::requireWarp("disk");
    EXPECT_DOUBLE_EQ(catalog::distributionTolerance(disk, 0.0, 256), 0.003);
    // 1.2, 3.4 and 30 % for 256 bins at a = 0.05, 0.03, 0.01.
    EXPECT_NEAR(catalog::distributionTolerance(beckmann, 0.05, 256), 0.012, 0.0005);
    EXPECT_NEAR(catalog::distributionTolerance(beckmann, 0.03, 256), 0.034, 0.0005);
    EXPECT_NEAR(catalog::distributionTolerance(beckmann, 0.01, 256), 0.305, 0.005);
    EXPECT_NEAR(catalog::stratifiedTolerance(beckmann, 0.01, 1024), 4.8e-3, 0.1e-3);
    EXPECT_DOUBLE_EQ(catalog::stratifiedTolerance(disk, 0.0, 2048), 5e-4);
    EXPECT_DOUBLE_EQ(catalog::stratifiedTolerance(disk, 0.0, 256), 4e-3);
}
