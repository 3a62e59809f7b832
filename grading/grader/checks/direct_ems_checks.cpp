// SPDX-License-Identifier: MIT
#include <grader/checks/direct_ems_diagnosis.h>
#include <grader/checks/direct_ems_experiments.h>
#include <grader/checks/radiance_case.h>

#include <cmath>
#include <numbers>

#include "check_groups.h"
#include "radiance_check.h"
#include "room.h"

namespace grader {

namespace {

constexpr double kPi = std::numbers::pi;

Vector3d reflectedFromPoint(const Room &room, const Vector3d &point, const Vector3d &light,
                            const Vector3d &intensity) {
    const Vector3d toLight = light - point;
    const double cosTheta = room.floor.geometricNormal(0).dot(toLight.normalized());
    return room.albedo.cwiseProduct(intensity) *
           (std::max(0.0, cosTheta) / kPi / toLight.squaredNorm());
}

Vector3d reflectedFromPolygon(const Room &room, const Vector3d &point, const TestMesh &light,
                              const Vector3d &radiance) {
    const double irradiance =
        polygonIrradiance(point, room.floor.geometricNormal(0), light.positions);
    return room.albedo.cwiseProduct(radiance) * (irradiance / kPi);
}

RadianceCase pointLights(std::uint64_t seed) {
    Room room(seed);
    RadianceCase test = room.onFloor();
    test.expected.assign(test.rays.size(), Vector3d::Zero());
    constexpr int kLights = 5;
    test.diagnoses.lightCount = kLights;
    std::vector<std::vector<Vector3d>> lights(kLights);
    std::vector<Vector3d> intensities;
    Hypothesis noCosine{"ems.no_cosine", test.expected};
    Hypothesis cosineTwice{"ems.cosine_twice", test.expected};
    for (int i = 0; i < kLights; ++i) {
        const Vector3d position = room.world({-1.2 + 0.6 * i + room.random.uniform(-0.1, 0.1),
                                              room.random.uniform(-0.8, 0.8), 1.2 + 0.1 * i});
        const Vector3d intensity = room.random.color(1, 6);
        room.scene.addPointLight(position, intensity.cast<float>().cast<double>());
        intensities.push_back(intensity);
        for (std::size_t k = 0; k < test.rays.size(); ++k) {
            const Vector3d point = hitPoint(test.rays[k], room.floor);
            const Vector3d right = reflectedFromPoint(room, point, position, intensity);
            const double cosine =
                room.floor.geometricNormal(0).dot((position - point).normalized());
            test.expected[k] += right;
            lights[i].push_back(right);
            noCosine.expected[k] += right / cosine;
            cosineTwice.expected[k] += right * cosine;
        }
    }
    test.diagnoses.hypotheses = choiceMistakes(lights, intensities);
    test.diagnoses.hypotheses.push_back(std::move(noCosine));
    test.diagnoses.hypotheses.push_back(std::move(cosineTwice));
    test.files = room.scene.files();
    return test;
}

/// One light; everything `scale` times as large.
RadianceCase areaLight(std::uint64_t seed, double scale) {
    Room room(seed);
    const Vector3d radiance = room.random.color(3, 9);
    const TestMesh light = room.lightMesh({0.2, -0.1, 1.3}, 0.9, 0.55);
    RadianceCase test = room.onFloor();
    std::vector<LitPoint> points;
    for (const TestRay &ray : test.rays) {
        points.push_back({hitPoint(ray, room.floor), room.floor.geometricNormal(0), room.albedo});
        test.expected.push_back(
            reflectedFromPolygon(room, points.back().position, light, radiance));
    }
    test.diagnoses.isNoisy = true;
    if (scale == 1)
        test.diagnoses.hypotheses = areaLightMistakes(points, light, radiance);
    else
        test.diagnoses.other = "ems.self_shadow";
    // Radiance does not change when everything grows.
    const auto grow = [&](TestMesh mesh) {
        for (Vector3d &p : mesh.positions)
            p *= scale;
        return mesh.transformed(Eigen::Isometry3d::Identity());
    };
    for (TestRay &ray : test.rays)
        ray.origin = (ray.origin * scale).cast<float>().cast<double>();
    TestScene scene;
    scene.addMesh(grow(room.floor), room.albedo);
    scene.addLight(grow(light), {0.3, 0.4, 0.2},
                   {.radiance = radiance, .scale = {}, .texture = {}});
    test.files = scene.files();
    return test;
}

RadianceCase manyLights(std::uint64_t seed) {
    Room room(seed);
    RadianceCase test = room.onFloor();
    test.expected.assign(test.rays.size(), Vector3d::Zero());
    const double sizes[] = {0.25, 0.6, 0.4};
    for (int i = 0; i < 3; ++i) {
        const Vector3d radiance = room.random.color(2, 9);
        const TestMesh light =
            room.lightMesh({-0.9 + 0.9 * i, 0.4 - 0.35 * i, 1.5}, sizes[i], 0.5 * sizes[i] + 0.1);
        room.scene.addLight(light, {0.5, 0.5, 0.5},
                            {.radiance = radiance, .scale = {}, .texture = {}});
        for (std::size_t k = 0; k < test.rays.size(); ++k)
            test.expected[k] +=
                reflectedFromPolygon(room, hitPoint(test.rays[k], room.floor), light, radiance);
    }
    for (int i = 0; i < 2; ++i) {
        const Vector3d position =
            room.world({-0.5 + i, 0.3 * i - 0.2, 0.9}).cast<float>().cast<double>();
        const Vector3d intensity = room.random.color(0.5, 2);
        room.scene.addPointLight(position, intensity);
        for (std::size_t k = 0; k < test.rays.size(); ++k)
            test.expected[k] +=
                reflectedFromPoint(room, hitPoint(test.rays[k], room.floor), position, intensity);
    }
    test.diagnoses.lightCount = 5;
    test.files = room.scene.files();
    return test;
}

/// Rays that meet nothing: what the environment sends, exactly.
RadianceCase background(std::uint64_t seed) {
    Room room(seed);
    room.scene.addFile(kSkyMapName, skyMap());
    room.scene.addEnvironment({255, 230, 200}, kSkyMapName);
    RadianceCase test;
    const Vector3d up = room.floor.geometricNormal(0);
    const Vector3d origin = room.world({0, 0, 0.5});
    while (test.rays.size() < static_cast<std::size_t>(Room::kColumns) * 4) {
        const Vector3d direction = room.random.direction();
        if (direction.dot(up) > 0.1)
            test.rays.push_back({origin, direction.cast<float>().cast<double>()});
    }
    test.files = room.scene.files();
    test.repeats = 4;
    test.diagnoses.black = "ems.environment_not_seen";
    return test;
}

/// Rays straight at a light from its front, or from behind.
RadianceCase visibleLight(std::uint64_t seed, bool fromBehind) {
    Room room(seed);
    const Vector3d radiance = room.random.color(1, 5);
    const TestMesh light = room.lightMesh({0.2, -0.1, 1.3}, 0.9, 0.55);
    room.scene.addLight(light, {0, 0, 0}, {.radiance = radiance, .scale = {}, .texture = {}});
    RadianceCase test;
    test.rays = raysOnto(light, Room::kColumns, fromBehind ? -0.6 : 0.6, room.random);
    test.expected.assign(test.rays.size(), fromBehind ? Vector3d::Zero().eval() : radiance);
    test.files = room.scene.files();
    test.repeats = 16;
    test.diagnoses.black = "ems.visible_light_missing";
    test.diagnoses.other = fromBehind ? "ems.light_seen_from_behind" : "ems.visible_light_twice";
    test.diagnoses.otherFit = 0.6;
    return test;
}

/// About how much of what is seen of reflectingLight() is reflected: the rest, which is emitted,
/// hides most of an error in that.
constexpr double kReflectedShare = 0.25;

/// A light that is lit by another one: it emits and reflects.
RadianceCase reflectingLight(std::uint64_t seed) {
    Room room(seed);
    const Vector3d radiance = room.random.color(0.5, 1);
    const Vector3d intensity = room.random.color(2, 5);
    const Vector3d position = room.world({0.3, 0.2, 1.4}).cast<float>().cast<double>();
    room.scene = TestScene();
    room.scene.addLight(room.floor, room.albedo,
                        {.radiance = radiance, .scale = {}, .texture = {}});
    room.scene.addPointLight(position, intensity);
    RadianceCase test = room.onFloor();
    test.diagnoses.hypotheses = {{"ems.reflection_dropped", {}}, {"ems.visible_light_missing", {}}};
    for (const TestRay &ray : test.rays) {
        const Vector3d reflected =
            reflectedFromPoint(room, hitPoint(ray, room.floor), position, intensity);
        test.expected.emplace_back(radiance + reflected);
        test.diagnoses.hypotheses[0].expected.push_back(radiance);
        test.diagnoses.hypotheses[1].expected.push_back(reflected);
    }
    test.diagnoses.other = "ems.reflection_dropped";
    test.files = room.scene.files();
    return test;
}

/// A plate a twentieth of a unit above half of the floor: a shadow ray that starts too far away
/// jumps over it. The eye looks from under it.
RadianceCase nearShadow(std::uint64_t seed) {
    constexpr double kHeight = 0.05;
    constexpr double kUnsure = 0.01; // so close to the plate's edge, roundings decide
    Room room(seed);
    const Vector3d light(0.2, -0.1, 1.3);
    const Vector3d intensity = room.random.color(1, 6).cast<float>().cast<double>();
    room.scene.addMesh(
        parallelogram({-2, -2, kHeight}, {2, 0, 0}, {0, 4, 0}).transformed(room.pose),
        {0.4, 0.5, 0.6});
    room.scene.addPointLight(room.world(light), intensity);
    RadianceCase test;
    test.columns = Room::kColumns;
    while (test.rays.size() < static_cast<std::size_t>(Room::kColumns) * 16) {
        const Vector3d point(room.random.uniform(-1, 0.9), room.random.uniform(-0.8, 0.9), 0);
        const Vector3d atPlate = point + kHeight / light.z() * (light - point);
        if (std::abs(atPlate.x()) < kUnsure)
            continue;
        const Vector3d tilt = 0.5 * kHeight * room.random.direction();
        const Vector3d eye = room.world(point + Vector3d(tilt.x(), tilt.y(), 0.4 * kHeight));
        TestRay ray{eye, (room.world(point) - eye).normalized().cast<float>().cast<double>()};
        const Vector3d right =
            reflectedFromPoint(room, hitPoint(ray, room.floor), room.world(light), intensity);
        test.expected.push_back(atPlate.x() < 0 ? Vector3d::Zero().eval() : right);
        test.rays.push_back(ray);
    }
    test.files = room.scene.files();
    test.repeats = 16;
    return test;
}

} // namespace

std::vector<Check> directEmsChecks() {
    return {
        radianceCheck("point_lights", "Five coloured point lights add up to the closed form.",
                      pointLights),
        radianceCheck("area_light", "A parallelogram light gives Lambert's formula.",
                      [](std::uint64_t seed) { return areaLight(seed, 1); }),
        radianceCheck("many_lights",
                      "Three area and two point lights together give the closed form.", manyLights),
        radianceCheck(
            "visible_light", "A light that is seen shows its radiance.",
            [](std::uint64_t seed) { return visibleLight(seed, false); }, experimentWithSides),
        radianceCheck("background", "Where nothing is hit, the environment is seen.", background),
        radianceCheck(
            "light_behind", "A light seen from behind is dark.",
            [](std::uint64_t seed) { return visibleLight(seed, true); }, experimentWithSides),
        radianceCheck("reflecting_light", "A light reflects what another light sends.",
                      reflectingLight, nullptr, kGrossRadiance * kReflectedShare),
        radianceCheck("large_scene", "A scene in units 300 times smaller gives the same image.",
                      [](std::uint64_t seed) { return areaLight(seed, 300); }),
        radianceCheck("near_shadow", "A plate close above a surface hides the light.", nearShadow,
                      experimentWithOneLight),
    };
}

} // namespace grader
