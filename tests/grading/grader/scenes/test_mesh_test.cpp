// SPDX-License-Identifier: MIT
#include <grader/scenes/test_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace grader {
namespace {

using std::numbers::pi;

/// Irradiance by summing small patches of a parallelogram.
double summedIrradiance(const Vector3d &point, const Vector3d &normal, const TestMesh &light,
                        int steps) {
    const Vector3d a = light.positions[1] - light.positions[0];
    const Vector3d b = light.positions[3] - light.positions[0];
    const Vector3d lightNormal = light.geometricNormal(0);
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        for (int j = 0; j < steps; ++j) {
            const Vector3d to =
                light.positions[0] + (i + 0.5) / steps * a + (j + 0.5) / steps * b - point;
            const double cosines = std::max(0.0, to.normalized().dot(normal)) *
                                   std::abs(to.normalized().dot(lightNormal));
            sum += cosines / to.squaredNorm() * a.cross(b).norm() / (steps * steps);
        }
    }
    return sum;
}

TEST(TestMesh, PolygonIrradianceIsTheSumOverItsPatches) {
    const TestMesh light = parallelogram({-0.4, -0.3, 1.2}, {0.9, 0.1, 0.2}, {0.1, 0.7, -0.1});
    const Vector3d normal = Vector3d(0.2, -0.1, 1).normalized();
    // Midpoint rule at 400^2: error below 1e-5 on this smooth integrand.
    EXPECT_NEAR(polygonIrradiance({0.1, 0.2, 0}, normal, light.positions),
                summedIrradiance({0.1, 0.2, 0}, normal, light, 400), 1e-5);
}

TEST(TestMesh, PolygonIrradianceClipsAtTheHorizon) {
    // A vertical light, half of it below the horizon.
    const TestMesh light = parallelogram({1, -0.5, -0.7}, {0, 1, 0}, {0, 0, 1.5});
    EXPECT_NEAR(polygonIrradiance({0, 0, 0}, Vector3d::UnitZ(), light.positions),
                summedIrradiance({0, 0, 0}, Vector3d::UnitZ(), light, 600), 1e-4);
}

TEST(TestMesh, ALargeSquareOverheadGivesPi) {
    const TestMesh sky = parallelogram({-1e4, -1e4, 1}, {2e4, 0, 0}, {0, 2e4, 0});
    EXPECT_NEAR(polygonIrradiance({0, 0, 0}, Vector3d::UnitZ(), sky.positions), pi, 1e-3);
}

TEST(TestMesh, SphereHasNearlyItsArea) {
    EXPECT_NEAR(sphere({1, 2, 3}, 0.5, 60).area(), pi, 0.01);
}

TEST(TestMesh, PatchCoversItsParallelogramWithUnequalTriangles) {
    SceneRandom random(5);
    const Vector3d a(0.9, 0.1, 0.2);
    const Vector3d b(0.1, 0.7, -0.1);
    const TestMesh mesh = patch({1, 2, 3}, a, b, 3, random);
    EXPECT_EQ(mesh.faces.size(), 18u);
    EXPECT_NEAR(mesh.area(), a.cross(b).norm(), 1e-12);
    EXPECT_GT(std::abs(mesh.area(0) / mesh.area(8) - 1), 0.01);
    for (std::size_t face = 0; face < mesh.faces.size(); ++face)
        EXPECT_GT(mesh.geometricNormal(face).dot(a.cross(b)), 0);
}

TEST(TestMesh, BlockHasItsNormalsOutside) {
    const Vector3d center(0.5, -1, 2);
    const TestMesh mesh = block(center, {1, 2, 3}, 0.4);
    EXPECT_NEAR(mesh.area(), 2 * (2 + 6 + 3), 1e-12);
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
        const Vector3d corner = mesh.positions[static_cast<std::size_t>(mesh.faces[face][0])];
        EXPECT_GT(mesh.geometricNormal(face).dot(corner - center), 0);
    }
}

TEST(TestMesh, UnequalStripHasVeryUnequalTriangles) {
    SceneRandom random(7);
    const TestMesh strip = unequalStrip(random);
    double smallest = 1e9;
    double largest = 0;
    for (std::size_t face = 0; face < strip.faces.size(); ++face) {
        smallest = std::min(smallest, strip.area(face));
        largest = std::max(largest, strip.area(face));
    }
    EXPECT_GT(smallest, 0);
    EXPECT_GT(largest / smallest, 20);
}

TEST(SceneRandom, RotatesWithoutScaling) {
    SceneRandom random(3);
    for (int i = 0; i < 100; ++i) {
        const Eigen::Isometry3d pose = random.rigid(2);
        EXPECT_NEAR(pose.linear().determinant(), 1, 1e-12);
        EXPECT_LE(pose.translation().cwiseAbs().maxCoeff(), 2);
    }
}

} // namespace
} // namespace grader
