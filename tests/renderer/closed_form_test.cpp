// SPDX-License-Identifier: MIT
#include <nori/warp.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <ostream>
#include <tuple>

#include "closed_form.h"
#include "closed_form_scene.h"

// Every integrator of direct light against formulas, at a point (0.13, -0.21, 0) of a diffuse
// floor.

namespace nori {
namespace {

namespace closed_form = test::closed_form;
using test::addFloor;
using test::addMesh;
using test::addPolygon;
using test::emptyScene;
using test::expectMean;
using test::expectVariance;
using test::identity;
using test::kAlbedo;
using test::kPi;
using test::kRadiance;
using test::kScale;
using test::View;

/// A sky of radiance 1 + slope . direction, drawn uniformly.
class LinearSky : public Emitter {
public:
    explicit LinearSky(const Vector3f &slope) : m_slope(slope) {
        m_type = EmitterType::EMITTER_ENVIRONMENT;
    }

    Color3f sample(EmitterQueryRecord &lRec, const Point2f &sample, float) const override {
        lRec.wi = Warp::squareToUniformSphere(sample);
        lRec.dist = 1e6f;
        lRec.p = lRec.ref + lRec.dist * lRec.wi;
        lRec.pdf = pdf(lRec);
        return eval(lRec) / lRec.pdf;
    }

    float pdf(const EmitterQueryRecord &) const override { return INV_FOURPI; }

    Color3f eval(const EmitterQueryRecord &lRec) const override {
        return kRadiance * (1.0f + m_slope.dot(lRec.wi));
    }

    std::string toString() const override { return "LinearSky[]"; }

private:
    Vector3f m_slope;
};

void addSky(Scene &scene) {
    PropertyList props;
    props.setColor("radiance", kRadiance);
    scene.addChild(test::make<Emitter>("environment", props).release());
}

/// Many sides around the normal of kPoint, facing down.
std::vector<Eigen::Vector3d> diskAbove(double height, double radius) {
    constexpr int kSides = 512; // their area is 2.5e-5 below the circle's
    std::vector<Eigen::Vector3d> vertices;
    for (int i = 0; i < kSides; ++i) {
        const double angle = -2.0 * kPi * i / kSides;
        vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
    }
    return vertices;
}

/// A ball that shines outwards; its cross-section is 1e-4 below the sphere's.
void addBall(Scene &scene, const Eigen::Vector3d &center, double radius) {
    constexpr int kRings = 128;
    constexpr int kSides = 256;
    std::vector<Eigen::Vector3d> vertices;
    std::vector<Vector3i> faces;
    for (int i = 0; i <= kRings; ++i) {
        for (int j = 0; j < kSides; ++j) {
            const double theta = kPi * i / kRings;
            const double phi = 2.0 * kPi * j / kSides;
            vertices.emplace_back(center + radius * Eigen::Vector3d(std::sin(theta) * std::cos(phi),
                                                                    std::sin(theta) * std::sin(phi),
                                                                    std::cos(theta)));
            if (i == kRings)
                continue;
            const int next = (j + 1) % kSides;
            const int a = i * kSides + j;
            const int b = i * kSides + next;
            faces.emplace_back(a, a + kSides, b);
            faces.emplace_back(b, a + kSides, b + kSides);
        }
    }
    addMesh(scene, vertices, faces, kRadiance);
}

struct ClosedForm {
    const char *name;
    std::function<void(Scene &)> addLights;
    double irradiance; ///< under radiances of 1
};

std::ostream &operator<<(std::ostream &stream, const ClosedForm &form) {
    return stream << form.name;
}

std::vector<ClosedForm> closedForms() {
    using Eigen::Vector3d;
    const std::vector<Vector3d> above{{-0.9, -0.7, 1.3}, {0.2, 1.1, 0.9}, {1.6, -0.3, 1.9}};
    const std::vector<Vector3d> across{{1.2, -1.4, -0.8}, {1.3, -1.1, 1.5}, {1.1, 1.6, 0.7}};
    const Vector3d center(0.6, 0.5, 1.7);
    const Vector3d slope(0.3, -0.2, 0.6);
    const double angle = 0.7;
    return {
        {"Triangle", [=](Scene &scene) { addPolygon(scene, above); }, closed_form::polygon(above)},
        {"TriangleAcrossTheHorizon", [=](Scene &scene) { addPolygon(scene, across); },
         closed_form::polygon(across)},
        {"Sphere", [=](Scene &scene) { addBall(scene, center, 0.8); },
         closed_form::sphere(center, 0.8)},
        {"Disk", [](Scene &scene) { addPolygon(scene, diskAbove(1.3, 0.9)); },
         closed_form::disk(1.3, 0.9)},
        {"RectangleFromItsCorner",
         [](Scene &scene) {
             addPolygon(scene, {{0, 0, 0.8}, {0, 1.4, 0.8}, {1.1, 1.4, 0.8}, {1.1, 0, 0.8}});
         },
         closed_form::rectangle(1.1, 1.4, 0.8)},
        {"ConstantSky", addSky, kPi},
        {"LinearSky", [=](Scene &scene) { scene.addChild(new LinearSky(slope.cast<float>())); },
         closed_form::linearSky(slope)},
        {"SkyBehindADisk",
         [=](Scene &scene) {
             addSky(scene);
             addPolygon(scene, diskAbove(0.9, 0.9 * std::tan(angle)), Color3f(0.0f));
         },
         closed_form::skyBehindDisk(angle)},
    };
}

const char *const kIntegrators[] = {"direct_ems", "direct_mats", "direct_mis"};

class ClosedForms : public testing::TestWithParam<std::tuple<const char *, ClosedForm>> {};

TEST_P(ClosedForms, AreTheMeanOfTheIntegrator) {
    const auto &[integrator, form] = GetParam();
    const auto scene = emptyScene();
    addFloor(*scene);
    form.addLights(*scene);
    scene->activate();
    // sampling the BSDF finds a small light seldom
    const bool isRare = std::string(integrator) == "direct_mats" && form.irradiance < 1.5;
    expectMean(View(*scene, integrator).moments(150000, identity), kScale * form.irradiance,
               isRare ? 0.1 : 0.06);
}

INSTANTIATE_TEST_SUITE_P(Lights, ClosedForms,
                         testing::Combine(testing::ValuesIn(kIntegrators),
                                          testing::ValuesIn(closedForms())),
                         [](const auto &row) {
                             return std::string(std::get<0>(row.param)) + "_" +
                                    std::get<1>(row.param).name;
                         });

class Furnace : public testing::TestWithParam<const char *> {};

/// A closed box that shines inside, seen from within.
TEST_P(Furnace, ReflectsItsAlbedoOnceMore) {
    const auto scene = emptyScene();
    const std::vector<Eigen::Vector3d> corners{{-1, -1.2, 0}, {1.5, -1.2, 0}, {1.5, 0.9, 0},
                                               {-1, 0.9, 0},  {-1, -1.2, 2},  {1.5, -1.2, 2},
                                               {1.5, 0.9, 2}, {-1, 0.9, 2}};
    const std::vector<Vector3i> faces{{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6},
                                      {0, 5, 1}, {0, 4, 5}, {2, 6, 7}, {2, 7, 3},
                                      {1, 6, 2}, {1, 5, 6}, {0, 3, 7}, {0, 7, 4}};
    addMesh(*scene, corners, faces, kRadiance);
    scene->activate();
    expectMean(View(*scene, GetParam()).moments(60000, identity),
               static_cast<double>(kRadiance.g() * (1.0f + kAlbedo.g())), 0.02);
}

INSTANTIATE_TEST_SUITE_P(Integrators, Furnace, testing::ValuesIn(kIntegrators),
                         [](const auto &integrator) { return std::string(integrator.param); });

TEST(ClosedFormVariances, AreThoseOfUniformDirectionsAndAreas) {
    const auto sky = emptyScene();
    addFloor(*sky);
    addSky(*sky);
    sky->activate();
    const double radiance = kScale * kPi;
    expectVariance(*sky, radiance, 5.0 / 3.0 * radiance * radiance, 0.05);

    const auto disk = emptyScene();
    addFloor(*disk);
    addPolygon(*disk, diskAbove(1.3, 0.9));
    disk->activate();
    expectVariance(*disk, kScale * closed_form::disk(1.3, 0.9),
                   kScale * kScale * closed_form::diskVariance(1.3, 0.9), 0.05);
}

} // namespace
} // namespace nori
