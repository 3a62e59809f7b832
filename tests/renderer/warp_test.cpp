// SPDX-License-Identifier: MIT
#include <nori/warp.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "fixtures.h"

namespace nori {
namespace {

/// One warp; points of the plane have z = 0.
struct Row {
    const char *name;
    bool planar;
    std::function<Vector3f(const Point2f &)> warp;
    std::function<float(const Vector3f &)> pdf;
};

Row plane(const char *name, Point2f (*warp)(const Point2f &), float (*pdf)(const Point2f &)) {
    return {name, true,
            [warp](const Point2f &u) {
                const Point2f p = warp(u);
                return Vector3f(p.x(), p.y(), 0.0f);
            },
            [pdf](const Vector3f &v) {
                return pdf(Point2f(v.x(), v.y()));
            }};
}

Row sphere(const char *name, Vector3f (*warp)(const Point2f &), float (*pdf)(const Vector3f &)) {
    return {name, false, warp, pdf};
}

Row beckmann(const char *name, float alpha) {
    return {name, false, [alpha](const Point2f &u) { return Warp::squareToBeckmann(u, alpha); },
            [alpha](const Vector3f &m) {
                return Warp::squareToBeckmannPdf(m, alpha);
            }};
}

std::vector<Row> rows() {
    return {
        plane("Square", Warp::squareToUniformSquare, Warp::squareToUniformSquarePdf),
        plane("Tent", Warp::squareToTent, Warp::squareToTentPdf),
        plane("Disk", Warp::squareToUniformDisk, Warp::squareToUniformDiskPdf),
        plane("Triangle", Warp::squareToUniformTriangle, Warp::squareToUniformTrianglePdf),
        sphere("Sphere", Warp::squareToUniformSphere, Warp::squareToUniformSpherePdf),
        sphere("Hemisphere", Warp::squareToUniformHemisphere, Warp::squareToUniformHemispherePdf),
        sphere("CosineHemisphere", Warp::squareToCosineHemisphere,
               Warp::squareToCosineHemispherePdf),
        beckmann("Beckmann010", 0.1f),
        beckmann("Beckmann050", 0.5f),
        beckmann("Beckmann100", 1.0f)};
}

/// Largest |pdf * area of the image of a cell / area of the cell - 1| over a grid of cells. The
/// image's area is that of the parallelogram of central differences; h = 1/256 makes their error
/// about (h / u)^2 < 0.2 % for u in [0.1, 0.9], and rounding adds 2^-24 / h.
float inconsistency(const std::function<Vector3f(const Point2f &)> &warp,
                    const std::function<float(const Vector3f &)> &pdf) {
    constexpr float kStep = 1.0f / 256.0f;
    float worst = 0.0f;
    for (const Point2f &cell : test::squareGrid(16)) {
        const Point2f u = Point2f(0.1f, 0.1f) + 0.8f * cell;
        if ((u.array() - 0.5f).abs().minCoeff() < kStep) // the tent's kink
            continue;
        const Vector3f du = warp(u + Point2f(kStep, 0)) - warp(u - Point2f(kStep, 0));
        const Vector3f dv = warp(u + Point2f(0, kStep)) - warp(u - Point2f(0, kStep));
        const float area = du.cross(dv).norm() / (4.0f * kStep * kStep);
        worst = std::max(worst, std::abs(pdf(warp(u)) * area - 1.0f));
    }
    return worst;
}

class EveryWarp : public testing::TestWithParam<Row> {};

TEST_P(EveryWarp, HasTheDensityOfItsImages) {
    EXPECT_LT(inconsistency(GetParam().warp, GetParam().pdf), 0.01f);
}

TEST_P(EveryWarp, DoesNotHaveADensityThatIsTwoPercentOff) {
    const auto wrong = [](const Vector3f &v) {
        return 1.02f * GetParam().pdf(v);
    };
    EXPECT_GT(inconsistency(GetParam().warp, wrong), 0.01f);
}

TEST_P(EveryWarp, StaysInItsDomainAtTheEdgesOfTheSquare) {
    for (const Point2f &u : test::edgeInputs()) {
        const Vector3f v = GetParam().warp(u);
        ASSERT_TRUE(v.allFinite()) << u.toString();
        const float pdf = GetParam().pdf(v);
        EXPECT_TRUE(std::isfinite(pdf) && pdf >= 0.0f) << u.toString();
        if (!GetParam().planar) {
            EXPECT_NEAR(v.norm(), 1.0f, 1e-6f) << u.toString();
        }
    }
}

TEST_P(EveryWarp, HasADensityThatIntegratesToOne) {
    double sum = 0.0;
    if (GetParam().planar) {
        for (const Point2f &cell : test::squareGrid(1000)) {
            const Point2f p = 2.0f * cell - Point2f(1.0f);
            sum += static_cast<double>(GetParam().pdf(Vector3f(p.x(), p.y(), 0.0f))) * 4e-6;
        }
    } else { // rotationally symmetric
        constexpr int kCells = 10000;
        for (int i = 0; i < kCells; ++i) {
            const float z = -1.0f + 2.0f * (static_cast<float>(i) + 0.5f) / kCells;
            const Vector3f v(std::sqrt(1.0f - z * z), 0.0f, z);
            sum += static_cast<double>(GetParam().pdf(v)) * 4.0 * test::kPi / kCells;
        }
    }
    // Midpoint rule: a rim is missed by at most a cell's width of 0.002. Beckmann's peak of width
    // alpha^2 / 2 = 0.005 in z is hit up to (0.0002 / 0.005)^2 / 24.
    EXPECT_NEAR(sum, 1.0, 5e-3);
}

INSTANTIATE_TEST_SUITE_P(Warp, EveryWarp, testing::ValuesIn(rows()),
                         [](const auto &row) { return row.param.name; });

TEST(Warp, GivesDensityZeroOutsideTheDomain) {
    EXPECT_EQ(Warp::squareToUniformSquarePdf({1.1f, 0.5f}), 0.0f);
    EXPECT_EQ(Warp::squareToTentPdf({-1.1f, 0.0f}), 0.0f);
    EXPECT_EQ(Warp::squareToTentPdf({-1.1f, 1.1f}), 0.0f);
    EXPECT_EQ(Warp::squareToUniformDiskPdf({0.8f, 0.8f}), 0.0f);
    EXPECT_EQ(Warp::squareToUniformTrianglePdf({0.6f, 0.6f}), 0.0f);
    EXPECT_EQ(Warp::squareToUniformTrianglePdf({-0.1f, 0.5f}), 0.0f);
    EXPECT_EQ(Warp::squareToUniformHemispherePdf({0, 0, -1}), 0.0f);
    EXPECT_EQ(Warp::squareToCosineHemispherePdf({0, 0, -1}), 0.0f);
    EXPECT_EQ(Warp::squareToBeckmannPdf({0, 0, -1}, 0.5f), 0.0f);
    EXPECT_EQ(Warp::squareToBeckmannPdf({1, 0, 0}, 0.5f), 0.0f);
}

TEST(Warp, MatchesTheFormulasOfTheHandout) {
    EXPECT_FLOAT_EQ(Warp::squareToUniformTrianglePdf({0.2f, 0.3f}), 2.0f);
    EXPECT_FLOAT_EQ(Warp::squareToUniformSpherePdf({0, 0, -1}), 1.0f / (4.0f * M_PI));
    EXPECT_FLOAT_EQ(Warp::squareToUniformHemispherePdf({0, 0, 1}), 1.0f / (2.0f * M_PI));
    EXPECT_FLOAT_EQ(Warp::squareToCosineHemispherePdf({0.8f, 0, 0.6f}), 0.6f / M_PI);
    // equation (1) times cos(theta), at tan(theta) = 4/3 and alpha = 1
    const float expected = std::exp(-16.0f / 9.0f) / (M_PI * std::pow(0.6f, 3.0f));
    EXPECT_NEAR(Warp::squareToBeckmannPdf({0.8f, 0, 0.6f}, 1.0f), expected, 1e-6f);
}

} // namespace
} // namespace nori
