// SPDX-License-Identifier: MIT
#include "direct_ems_experiments.h"

#include <grader/checks/answer.h>
#include <grader/checks/radiance_case.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace grader {

namespace {

constexpr int kRepeats = 16;

/// Part of the brightest answer that counts as light: a constant that is added is none.
constexpr double kLit = 0.1;

/// Of all samples and channels along a ray.
struct Brightness {
    double mean = 0;
    double least = 0;
    double most = 0;
};

/// Scenes side by side, one ray and answer each.
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

    /// One a scene.
    /// \return  nothing if the code did not answer, or not with numbers
    std::optional<std::vector<Brightness>> run(CheckContext &context) const {
        const ProbeAnswer answer = context.ask(m_group);
        if (!answer.complete())
            return std::nullopt;
        std::vector<Brightness> result;
        for (const protocol::Response &response : answer.responses) {
            const auto [least, most] =
                std::minmax_element(response.values.begin(), response.values.end());
            double sum = 0;
            for (const double value : response.values)
                sum += value;
            if (!std::isfinite(sum) || response.values.empty())
                return std::nullopt;
            result.push_back({sum / static_cast<double>(response.values.size()), *least, *most});
        }
        return result;
    }

    /// Which scenes are lit, against the brightest.
    std::optional<std::vector<bool>> lit(CheckContext &context) const {
        const auto found = run(context);
        if (!found)
            return std::nullopt;
        double brightest = 0;
        for (const Brightness &scene : *found)
            brightest = std::max(brightest, scene.mean);
        std::vector<bool> result;
        for (const Brightness &scene : *found)
            result.push_back(scene.mean > kLit * brightest);
        return result;
    }

private:
    protocol::RequestGroup m_group;
};

TestMesh squareAt(const Vector3d &center, double half) {
    return parallelogram(center - Vector3d(half, half, 0), {2 * half, 0, 0}, {0, 2 * half, 0});
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
    const auto isLit = experiment.lit(context);
    if (!isLit || !(*isLit)[0])
        return {};
    if (!(*isLit)[1])
        return {{"ems.shadow_ray_too_long"}};
    const auto missed = std::count(isLit->begin() + 2, isLit->end(), true);
    if (missed == static_cast<std::ptrdiff_t>(std::size(kPlaces)))
        return {{"ems.no_shadow_ray"}};
    return missed > 0 ? std::vector<Guess>{{"ems.shadow_ends_early"}} : std::vector<Guess>{};
}

/// One light at one distance, ever lower above the floor.
std::vector<Guess> experimentWithSlant(CheckContext &context) {
    constexpr double kCosines[] = {0.97, 0.8, 0.6, 0.4, 0.25, 0.12};
    constexpr double kTolerance = 0.02;
    Experiment experiment;
    for (const double cosine : kCosines) {
        TestScene scene;
        scene.addMesh(parallelogram({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}), {0.5, 0.5, 0.5});
        const double sine = std::sqrt(1 - cosine * cosine);
        scene.addPointLight(1.2 * Vector3d(0.6 * sine, 0.8 * sine, cosine), {3, 3, 3});
        experiment.add(scene, {{0, 0, 0.5}, {0, 0, -1}});
    }
    const auto found = experiment.run(context);
    if (!found)
        return {};
    for (const Brightness &scene : *found) { // a point light has no noise
        if (!(scene.mean > 0) || scene.most - scene.least > kTolerance * scene.mean)
            return {};
    }
    const auto follows = [&](double power) {
        for (std::size_t i = 1; i < std::size(kCosines); ++i) {
            const double wanted = std::pow(kCosines[i] / kCosines[0], power);
            if (std::abs((*found)[i].mean / (*found)[0].mean / wanted - 1) > kTolerance)
                return false;
        }
        return true;
    };
    if (follows(1))
        return {};
    if (follows(0))
        return {{"ems.no_cosine"}};
    return {{follows(2) ? "ems.cosine_twice" : "ems.cosine_wrong", 0.9}};
}

} // namespace

std::vector<Guess> experimentWithOneLight(CheckContext &context) {
    std::vector<Guess> found = experimentWithShadows(context);
    return found.empty() ? experimentWithSlant(context) : found;
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
    const auto isLit = experiment.lit(context);
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
