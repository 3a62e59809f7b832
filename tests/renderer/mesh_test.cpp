// SPDX-License-Identifier: MIT
#include <nori/mesh.h>

#include <gtest/gtest.h>

#include "fixtures.h"

namespace nori {
namespace {

/// Triangles of area 0.5 (z = 0), 0 and 1.5 (z = 1), the empty one in between.
test::TestMesh unequalTriangles() {
    test::TestMesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {3, 0, 1}, {0, 1, 1}},
                        {{0, 1, 2}, {1, 1, 1}, {3, 4, 5}});
    mesh.activate();
    return mesh;
}

/// Moments of samplePosition() over a grid of inputs.
struct Moments {
    double upperFraction = 0.0; ///< share of the points at z = 1
    Vector3f upperMean;         ///< their mean
};

Moments moments(const Mesh &mesh) {
    Moments result;
    Vector3f sum;
    int upper = 0;
    const std::vector<Point2f> inputs = test::squareGrid(200);
    for (const Point2f &u : inputs) {
        Point3f p;
        Normal3f n;
        Point2f uv;
        mesh.samplePosition(u, p, n, uv);
        if (p.z() > 0.5f) {
            ++upper;
            sum += p;
        }
    }
    result.upperFraction = upper / static_cast<double>(inputs.size());
    result.upperMean = sum / static_cast<float>(upper);
    return result;
}

TEST(Mesh, SamplesTrianglesByAreaAndPointsUniformly) {
    const test::TestMesh mesh = unequalTriangles();
    const Moments result = moments(mesh);
    EXPECT_NEAR(result.upperFraction, 0.75, 0.005); // a column of the grid
    EXPECT_LT((result.upperMean - Vector3f(1.0f, 1.0f / 3.0f, 1.0f)).norm(), 0.01f); // centroid
}

TEST(Mesh, HasTheReciprocalOfItsAreaAsDensity) {
    const test::TestMesh mesh = unequalTriangles();
    EXPECT_FLOAT_EQ(mesh.surfaceArea(0), 0.5f);
    EXPECT_FLOAT_EQ(mesh.surfaceArea(2), 1.5f);
    EXPECT_FLOAT_EQ(mesh.pdf(Point3f()), 0.5f);
}

TEST(Mesh, NeverSamplesATriangleWithoutArea) {
    test::TestMesh mesh({{5, 5, 5}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                        {{0, 0, 0}, {1, 2, 3}, {0, 0, 0}});
    mesh.activate();
    for (const Point2f &u : test::edgeInputs()) {
        Point3f p;
        Normal3f n;
        Point2f uv;
        mesh.samplePosition(u, p, n, uv);
        EXPECT_EQ(p.z(), 0.0f) << u.toString();
        EXPECT_EQ(n.z(), 1.0f) << u.toString();
    }
}

TEST(Mesh, InterpolatesNormalsAndTextureCoordinates) {
    auto mesh = test::makeSquare(0.0f, true); // winding normal +z, uv = (x, y)
    MatrixXf normals(3, 4);
    normals << 1, 1, 1, 1, 0, 0, 0, 0, -1, -1, -1, -1;
    mesh->setNormals(normals);
    mesh->activate();
    for (const Point2f &u : test::squareGrid(8)) {
        Point3f p;
        Normal3f n;
        Point2f uv;
        mesh->samplePosition(u, p, n, uv);
        EXPECT_NEAR((uv - Point2f(p.x(), p.y())).norm(), 0.0f, 1e-6f);
        EXPECT_NEAR((n - Normal3f(INV_SQRT_TWO, 0, -INV_SQRT_TWO)).norm(), 0.0f, 1e-6f);
    }
}

TEST(Mesh, IntersectsTrianglesFromBothSides) {
    const auto mesh = test::makeSquare(1.0f, true);
    float u = 0, v = 0, t = 0;
    EXPECT_TRUE(mesh->rayIntersect(0, Ray3f({0.5f, -0.5f, 0}, {0, 0, 2}), u, v, t));
    EXPECT_FLOAT_EQ(t, 0.5f); // in units of the direction
    EXPECT_FLOAT_EQ(u, 0.5f); // from vertex 0 towards vertex 1
    EXPECT_FLOAT_EQ(v, 0.25f);
    EXPECT_TRUE(mesh->rayIntersect(0, Ray3f({0.5f, -0.5f, 2}, {0, 0, -1}), u, v, t));
    EXPECT_FALSE(mesh->rayIntersect(0, Ray3f({-0.5f, 0.5f, 0}, {0, 0, 1}), u, v, t)); // other half
    EXPECT_FALSE(mesh->rayIntersect(0, Ray3f({0.5f, -0.5f, 0}, {0, 0, 1}, 0.0f, 0.9f), u, v, t));
    EXPECT_FALSE(mesh->rayIntersect(0, Ray3f({0, 0, 1}, {1, 0, 0}), u, v, t)); // in its plane
}

TEST(Mesh, RefusesAnEmitterWithoutArea) {
    test::TestMesh mesh({{0, 0, 0}}, {{0, 0, 0}});
    mesh.addChild(NoriObjectFactory::createInstance("area", PropertyList()));
    EXPECT_THROW(mesh.activate(), NoriException);
}

TEST(Mesh, GetsADiffuseSurfaceUnlessItHasOne) {
    const test::TestMesh mesh = unequalTriangles();
    ASSERT_NE(mesh.getBSDF(), nullptr);
    EXPECT_FALSE(mesh.isEmitter());
    EXPECT_NE(mesh.toString().find("Diffuse"), std::string::npos);
}

} // namespace
} // namespace nori
