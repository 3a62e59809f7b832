// SPDX-License-Identifier: MIT
#include "direct_ems_diagnosis.h"

#include <grader/checks/answer.h>
#include <grader/checks/radiance_case.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>

namespace grader {

namespace {

constexpr int kNodes = 24; ///< midpoints per side of a light
constexpr int kRepeats = 16;

/// The mean of one sample of the light: area^a times the mean over it of
/// albedo / pi * radiance * cos(surface)^s * cos(light)^l * distance^d. Right is (1, 1, 1, -2).
struct LightLaw {
    const char *diagnosis;
    int area, surface, light, distance;
};

constexpr LightLaw kLaws[] = {
    {"ems.no_cosine", 1, 0, 1, -2},      {"ems.cosine_twice", 1, 2, 1, -2},
    {"ems.divided_twice", 2, 1, 2, -4},  {"ems.not_divided", 0, 1, 0, 0},
    {"ems.light_geometry", 1, 1, 0, 0},  {"ems.light_geometry", 1, 1, 0, -2},
    {"ems.light_geometry", 1, 1, 1, -1}, {"ems.light_geometry", 1, 1, 1, -4},
    {"ems.light_geometry", 1, 1, 1, 0},  {"ems.light_geometry", 1, 1, 2, -2},
    {"ems.light_geometry", 0, 1, 1, -2},
};

double applyLaw(const LightLaw &law, const LitPoint &point, const TestMesh &light) {
    const Vector3d &corner = light.positions[0];
    const Vector3d a = light.positions[1] - corner;
    const Vector3d b = light.positions[3] - corner;
    const Vector3d normal = light.geometricNormal(0);
    double sum = 0;
    for (int i = 0; i < kNodes; ++i) {
        for (int j = 0; j < kNodes; ++j) {
            const Vector3d toLight =
                corner + (i + 0.5) / kNodes * a + (j + 0.5) / kNodes * b - point.position;
            const double distance = toLight.norm();
            const double surface = std::max(0.0, point.normal.dot(toLight) / distance);
            const double atLight = std::max(0.0, -normal.dot(toLight) / distance);
            sum += std::pow(surface, law.surface) * std::pow(atLight, law.light) *
                   std::pow(distance, law.distance);
        }
    }
    return std::pow(light.area(), law.area) * sum / (double{kNodes} * kNodes);
}

/// Scenes side by side, one ray and answer each: is it lit?
class Experiment {
public:
    void add(const TestScene &scene, const TestRay &ray) {
        const std::string folder = fmt::format("part{}", m_group.requests.size());
        for (protocol::File file : scene.files()) {
            file.name = folder + "/" + file.name;
            m_group.files.push_back(std::move(file));
        }
        RadianceCase one;
        one.rays = {ray};
        protocol::Request request =
            radianceRequest(one, kRepeats, m_group.requests.size() + 1).requests[0];
        request.text = folder + "/" + request.text;
        m_group.requests.push_back(std::move(request));
    }

    /// \return  nothing if the code did not answer
    std::optional<std::vector<bool>> run(CheckContext &context) const {
        const ProbeAnswer answer = context.ask(m_group);
        if (!answer.complete())
            return std::nullopt;
        std::vector<bool> lit;
        for (const protocol::Response &response : answer.responses)
            lit.push_back(std::any_of(response.values.begin(), response.values.end(),
                                      [](float value) { return value > 0; }));
        return lit;
    }

private:
    protocol::RequestGroup m_group;
};

TestMesh squareAt(const Vector3d &center, double half) {
    return parallelogram(center - Vector3d(half, half, 0), {2 * half, 0, 0}, {0, 2 * half, 0});
}

} // namespace

std::vector<Hypothesis> areaLightMistakes(const std::vector<LitPoint> &points,
                                          const TestMesh &light, const Vector3d &radiance) {
    std::vector<Hypothesis> hypotheses;
    for (const LightLaw &law : kLaws) {
        Hypothesis hypothesis{law.diagnosis, {}};
        for (const LitPoint &point : points)
            hypothesis.expected.emplace_back(point.albedo.cwiseProduct(radiance) *
                                             (applyLaw(law, point, light) / std::numbers::pi));
        hypotheses.push_back(std::move(hypothesis));
    }
    return hypotheses;
}

std::vector<Guess> experimentWithShadows(CheckContext &context) {
    constexpr double kPlaces[] = {0.003, 0.02, 0.1, 0.3, 0.5, 0.7, 0.85, 0.95, 0.98};
    const Vector3d lit(0.13, -0.07, 0);
    const Vector3d light(0.17, 0.02, 1.1);
    // Looks along the floor, below all but the lowest blockers, which are small.
    const auto ray = [&] {
        const Vector3d origin = lit + Vector3d(0.4, 0.1, 0.0008);
        return TestRay{origin, (lit - origin).normalized()};
    }();
    const auto scene = [&] {
        TestScene result;
        result.addMesh(parallelogram({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}), {0.5, 0.6, 0.7});
        result.addPointLight(light, {2, 3, 4});
        return result;
    };
    Experiment experiment;
    experiment.add(scene(), ray);
    TestScene behind = scene();
    behind.addMesh(squareAt({0.2, 0, 1.5}, 0.5), {0.5, 0.5, 0.5});
    experiment.add(behind, ray);
    for (const double place : kPlaces) {
        TestScene blocked = scene();
        blocked.addMesh(squareAt(lit + place * (light - lit), 0.12), {0.5, 0.5, 0.5});
        experiment.add(blocked, ray);
    }
    const auto isLit = experiment.run(context);
    if (!isLit || !(*isLit)[0])
        return {};
    if (!(*isLit)[1])
        return {{"ems.shadow_ray_too_long"}};
    const auto missed = std::count(isLit->begin() + 2, isLit->end(), true);
    if (missed == static_cast<std::ptrdiff_t>(std::size(kPlaces)))
        return {{"ems.no_shadow_ray"}};
    return missed > 0 ? std::vector<Guess>{{"ems.shadow_ends_early"}} : std::vector<Guess>{};
}

std::vector<Guess> experimentWithSides(CheckContext &context) {
    Experiment experiment;
    for (const double origin : {-1.0, 1.0}) { // where the world's origin is, seen from the light
        for (const double eye : {-1.0, 1.0}) {
            const Vector3d center(0.1, 0.2, -origin);
            TestMesh light = squareAt(center, 0.5); // its front is +z
            TestScene scene;
            scene.addLight(light, {0, 0, 0}, {.radiance = {2, 3, 4}, .scale = {}, .texture = {}});
            const Vector3d from = center + Vector3d(0.1, 0.05, 0.7 * eye);
            experiment.add(scene, {from, (center - from).normalized()});
        }
    }
    const auto isLit = experiment.run(context);
    if (!isLit)
        return {};
    const std::vector<bool> &lit = *isLit;
    const bool byOrigin = lit[0] == lit[1] && lit[2] == lit[3] && lit[0] != lit[2];
    if (byOrigin)
        return {{"ems.seen_from_origin"}};
    if (!lit[1] && !lit[3])
        return {{"ems.visible_light_missing"}};
    return lit[0] || lit[2] ? std::vector<Guess>{{"ems.light_seen_from_behind"}}
                            : std::vector<Guess>{};
}

} // namespace grader
