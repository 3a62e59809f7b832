// SPDX-License-Identifier: MIT
#include <nori/accel.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <pcg32.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <iterator>

#include "fixtures.h"

namespace nori {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// A mesh of triangles with corners in [-1, 1]^3, thin ones among them.
std::unique_ptr<test::TestMesh> makeSoup(pcg32 &random, int count) {
    std::vector<Point3f> vertices;
    std::vector<Vector3i> faces;
    const auto point = [&random](float size) -> Vector3f {
        return Vector3f(random.nextFloat() - 0.5f, random.nextFloat() - 0.5f,
                        random.nextFloat() - 0.5f) *
               size;
    };
    for (int i = 0; i < count; ++i) {
        const Point3f center = point(1.6f);
        for (int corner = 0; corner < 3; ++corner)
            vertices.emplace_back(center + point(i % 4 == 0 ? 0.02f : 0.4f));
        faces.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    return std::make_unique<test::TestMesh>(vertices, faces);
}

struct Hit {
    const Mesh *mesh = nullptr;
    double t = std::numeric_limits<double>::infinity();
};

/// The nearest hit by asking every triangle in double precision (Moeller and Trumbore 1997).
Hit bruteForce(const std::vector<const Mesh *> &meshes, const Ray3f &ray) {
    Hit hit;
    const Eigen::Vector3d o = ray.o.cast<double>();
    const Eigen::Vector3d d = ray.d.cast<double>();
    for (const Mesh *mesh : meshes) {
        for (Eigen::Index face = 0; face < mesh->getIndices().cols(); ++face) {
            const auto corner = [&](Eigen::Index i) -> Eigen::Vector3d {
                return mesh->getVertexPositions().col(mesh->getIndices()(i, face)).cast<double>();
            };
            const Eigen::Vector3d p0 = corner(0);
            const Eigen::Vector3d edge1 = corner(1) - p0;
            const Eigen::Vector3d edge2 = corner(2) - p0;
            const Eigen::Vector3d p = d.cross(edge2);
            const double determinant = edge1.dot(p);
            const Eigen::Vector3d s = o - p0;
            const double u = s.dot(p) / determinant;
            const Eigen::Vector3d q = s.cross(edge1);
            const double v = d.dot(q) / determinant;
            const double t = edge2.dot(q) / determinant;
            const bool inside = u >= 0.0 && v >= 0.0 && u + v <= 1.0;
            if (inside && t > static_cast<double>(ray.mint) && t < static_cast<double>(ray.maxt) &&
                t < hit.t)
                hit = {mesh, t};
        }
    }
    return hit;
}

TEST(Accel, FindsWhatAskingEveryTriangleFinds) {
    pcg32 random;
    random.seed(1, 1);
    Accel accel;
    std::vector<const Mesh *> meshes;
    for (int i = 0; i < 3; ++i) {
        auto mesh = makeSoup(random, 60);
        meshes.push_back(mesh.get());
        accel.addMesh(mesh.release());
    }
    accel.build();
    EXPECT_EQ(accel.getMeshCount(), 3u);
    EXPECT_EQ(accel.getTriangleCount(), 180u);

    constexpr int kRays = 4000;
    int hits = 0;
    int disagreements = 0;
    for (int i = 0; i < kRays; ++i) {
        const auto random3 = [&random]() -> Vector3f {
            return Vector3f(random.nextFloat(), random.nextFloat(), random.nextFloat()) * 2.0f -
                   Vector3f(1.0f);
        };
        const Point3f origin = random3();
        const Ray3f ray(origin, random3(), 0.01f, i % 2 == 0 ? kInfinity : 1.0f);
        const Hit expected = bruteForce(meshes, ray);
        Intersection its;
        const bool hit = accel.rayIntersect(ray, its);
        // through an edge, float and double may differ
        const bool agrees = hit == (expected.mesh != nullptr) &&
                            (!hit || (its.mesh == expected.mesh &&
                                      std::abs(static_cast<double>(its.t) - expected.t) < 1e-4));
        disagreements += agrees ? 0 : 1;
        hits += hit ? 1 : 0;
        EXPECT_EQ(accel.rayIntersect(ray, its, true), hit);
    }
    EXPECT_GT(hits, kRays / 10);
    EXPECT_LE(disagreements, 2);
}

/// The square at z = 1 and, if `closer`, another at z = 0.5.
std::unique_ptr<Accel> makeSquares(bool closer) {
    auto accel = std::make_unique<Accel>();
    accel->addMesh(test::makeSquare(1.0f, false).release());
    if (closer)
        accel->addMesh(test::makeSquare(0.5f, false).release());
    accel->build();
    return accel;
}

TEST(Accel, FillsInTheNearestHit) {
    const auto accel = makeSquares(true);
    Intersection its;
    // twice the unit direction: t counts in its lengths
    ASSERT_TRUE(accel->rayIntersect(Ray3f(Point3f(0.25f, -0.5f, 0), Vector3f(0, 0, 2)), its));
    EXPECT_EQ(its.mesh, accel->getMesh(1));
    EXPECT_FLOAT_EQ(its.t, 0.25f);
    EXPECT_TRUE(its.p.isApprox(Point3f(0.25f, -0.5f, 0.5f), 1e-6f));
    EXPECT_TRUE(its.uv.isApprox(Point2f(0.25f, -0.5f), 1e-6f));
    EXPECT_TRUE(its.geoFrame.n.isApprox(Normal3f(0, 0, -1)));
    EXPECT_TRUE(its.shFrame.n.isApprox(Normal3f(0, 0, -1)));
}

TEST(Accel, InterpolatesNormalsAndFallsBackToBarycentricUv) {
    auto mesh = std::make_unique<test::TestMesh>(
        std::vector<Point3f>{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}, std::vector<Vector3i>{{0, 2, 1}});
    MatrixXf normals(3, 3);
    normals << 0, 1, 0, 0, 0, 1, -1, 0, 0;
    mesh->setNormals(normals);
    Accel accel;
    accel.addMesh(mesh.release());
    accel.build();
    Intersection its;
    ASSERT_TRUE(accel.rayIntersect(Ray3f(Point3f(0.25f, 0.5f, 0), Vector3f(0, 0, 1)), its));
    // weights 0.25, 0.5 and 0.25 of the corners 0, 2 and 1
    EXPECT_TRUE(its.uv.isApprox(Point2f(0.5f, 0.25f), 1e-6f)) << its.uv;
    EXPECT_TRUE(its.shFrame.n.isApprox(Normal3f(0.25f, 0.5f, -0.25f).normalized(), 1e-6f));
    EXPECT_TRUE(its.geoFrame.n.isApprox(Normal3f(0, 0, -1)));
}

TEST(Accel, KeepsToTheRaysSegment) {
    const auto accel = makeSquares(false);
    const Point3f origin(0.0f, 0.1f, 0.0f);
    const Vector3f up(0, 0, 1);
    Intersection its;
    for (const bool shadow : {false, true}) {
        EXPECT_TRUE(accel->rayIntersect(Ray3f(origin, up, 0.9f, 1.1f), its, shadow));
        EXPECT_FALSE(accel->rayIntersect(Ray3f(origin, up, 0.1f, 0.99f), its, shadow));
        EXPECT_FALSE(accel->rayIntersect(Ray3f(origin, up, 1.01f, 5.0f), its, shadow));
        EXPECT_FALSE(accel->rayIntersect(Ray3f(origin, up, 2.0f, 1.0f), its, shadow));
        EXPECT_FALSE(accel->rayIntersect(Ray3f(origin, -up), its, shadow));
    }
    EXPECT_EQ(its.t, kInfinity);
}

TEST(Accel, TakesSegmentsThatBeginBehindTheOrigin) {
    const auto accel = makeSquares(true); // at z = 1 and 0.5
    const Vector3f up(0, 0, 2);
    Intersection its;
    ASSERT_TRUE(accel->rayIntersect(Ray3f(Point3f(0.1f, 0, 2), up, -1.0f, kInfinity), its));
    EXPECT_FLOAT_EQ(its.t, -0.75f); // the nearest is the one farthest behind
    EXPECT_TRUE(its.p.isApprox(Point3f(0.1f, 0, 0.5f), 1e-6f));
    ASSERT_TRUE(accel->rayIntersect(Ray3f(Point3f(0.1f, 0, 2), up, -0.6f, -0.1f), its));
    EXPECT_FLOAT_EQ(its.t, -0.5f);
    EXPECT_FALSE(accel->rayIntersect(Ray3f(Point3f(0.1f, 0, 2), up, -0.4f, kInfinity), its));
    EXPECT_TRUE(accel->rayIntersect(Ray3f(Point3f(0.1f, 0, 2), up, -1.0f, 0.0f), its, true));
    EXPECT_FALSE(accel->rayIntersect(Ray3f(Point3f(0.1f, 0, 2), up, -0.4f, 0.0f), its, true));
}

TEST(Accel, GrowsTheDefaultStartWithTheCoordinates) {
    Accel accel;
    accel.addMesh(test::makeSquare(1000.0f, false).release());
    accel.build();
    const Point3f origin(0.0f, 0.1f, 999.95f); // within 1e-4 * 1000 of the square
    Intersection its;
    EXPECT_FALSE(accel.rayIntersect(Ray3f(origin, Vector3f(0, 0, 1)), its));
    EXPECT_TRUE(accel.rayIntersect(Ray3f(origin, Vector3f(0, 0, 1), 1e-3f, kInfinity), its));
}

TEST(Accel, LetsNothingThroughTheEdgeOfTwoTriangles) {
    const auto accel = makeSquares(false);
    Intersection its;
    for (int i = -99; i < 100; ++i) {
        const float at = static_cast<float>(i) / 100.0f; // on the diagonal
        EXPECT_TRUE(accel->rayIntersect(Ray3f(Point3f(at, at, 0), Vector3f(0, 0, 1)), its)) << i;
    }
}

TEST(Accel, HitsNothingWhereThereIsNothing) {
    Accel accel;
    accel.build();
    Intersection its;
    EXPECT_FALSE(accel.rayIntersect(Ray3f(Point3f(0.0f), Vector3f(0, 0, 1)), its));
    EXPECT_EQ(accel.getTriangleCount(), 0u);
    EXPECT_FALSE(accel.getBoundingBox().isValid());
}

TEST(Accel, SurvivesRaysThatAreNotFinite) {
    const auto accel = makeSquares(false);
    Intersection its;
    for (const float value : {static_cast<float>(NAN), kInfinity}) {
        EXPECT_FALSE(accel->rayIntersect(Ray3f(Point3f(value), Vector3f(0, 0, 1)), its));
        EXPECT_FALSE(accel->rayIntersect(Ray3f(Point3f(0.0f), Vector3f(value)), its));
    }
    EXPECT_FALSE(accel->rayIntersect(Ray3f(Point3f(0.0f), Vector3f(0.0f)), its));
}

TEST(Accel, SurvivesEveryMixOfExtremeNumbers) {
    const auto accel = makeSquares(false);
    const float values[] = {0.0f,   -0.0f, 1.0f,      -1.0f,      1e-45f,
                            1e-38f, 1e18f, -1e18f,    1e19f,      3e38f,
                            -3e38f, 1e-4f, kInfinity, -kInfinity, static_cast<float>(NAN)};
    pcg32 random;
    random.seed(1, 1);
    const auto any = [&] {
        return values[random.nextUInt(static_cast<uint32_t>(std::size(values)))];
    };
    for (int i = 0; i < 100000; ++i) {
        const Point3f origin(any(), any(), any());
        const Vector3f direction(any(), any(), any());
        const float mint = any();
        const Ray3f ray(origin, direction, mint, any());
        Intersection its;
        if (accel->rayIntersect(ray, its)) {
            ASSERT_TRUE(its.p.allFinite()) << ray.toString();
        }
        accel->rayIntersect(ray, its, true);
    }
}

TEST(Accel, FallsBackToTheTrianglesNormalWhereTheVerticesGiveNone) {
    auto mesh = test::makeSquare(1.0f, false);
    mesh->setNormals(MatrixXf::Zero(3, 4));
    Accel accel;
    accel.addMesh(mesh.release());
    accel.build();
    Intersection its;
    ASSERT_TRUE(accel.rayIntersect(Ray3f(Point3f(0.1f, 0, 0), Vector3f(0, 0, 1)), its));
    EXPECT_TRUE(its.shFrame.n.isApprox(Normal3f(0, 0, -1)));
}

/// Which of two equal meshes 5000 rays hit, after building on some threads.
std::vector<bool> choicesBetweenEqualMeshes(int threads) {
    tbb::task_arena arena(threads);
    Accel accel;
    for (int i = 0; i < 2; ++i) {
        pcg32 random;
        random.seed(1, 1);
        accel.addMesh(makeSoup(random, 5000).release());
    }
    arena.execute([&] { accel.build(); });
    pcg32 random;
    random.seed(2, 2);
    std::vector<bool> choices;
    for (int i = 0; i < 5000; ++i) {
        const Point3f origin(random.nextFloat(), random.nextFloat(), -2.0f);
        Intersection its;
        if (accel.rayIntersect(Ray3f(origin, Vector3f(-0.1f, -0.1f, 1)), its))
            choices.push_back(its.mesh == accel.getMesh(0));
    }
    return choices;
}

TEST(Accel, ChoosesAlikeBetweenEqualTrianglesOnAnyNumberOfThreads) {
    const std::vector<bool> one = choicesBetweenEqualMeshes(1);
    EXPECT_GT(one.size(), 4000u);
    for (const int threads : {1, 2, 3, 16})
        EXPECT_EQ(choicesBetweenEqualMeshes(threads), one) << threads;
}

} // namespace
} // namespace nori
