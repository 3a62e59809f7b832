// SPDX-License-Identifier: MIT
#include "direct_ems_diagnosis.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace grader {

namespace {

constexpr int kNodes = 24; ///< midpoints per side of a light

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

/// Sums over the lights, each with a weight of its own.
Hypothesis weighted(const char *diagnosis, const std::vector<std::vector<Vector3d>> &lights,
                    const std::vector<double> &weights) {
    Hypothesis result{diagnosis, {}};
    for (std::size_t k = 0; k < lights.front().size(); ++k) {
        Vector3d sum = Vector3d::Zero();
        for (std::size_t i = 0; i < lights.size(); ++i)
            sum += weights[i] * lights[i][k];
        result.expected.push_back(sum);
    }
    return result;
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

std::vector<Hypothesis> choiceMistakes(const std::vector<std::vector<Vector3d>> &lights,
                                       const std::vector<Vector3d> &intensities) {
    std::vector<Hypothesis> mistakes;
    const auto alone = [&](const char *diagnosis, std::size_t light, double weight) {
        std::vector<double> weights(lights.size(), 0);
        weights[light] = weight;
        mistakes.push_back(weighted(diagnosis, lights, weights));
    };
    for (const Vector3d &weights : {Vector3d(0.212671, 0.715160, 0.072169), Vector3d(1, 1, 1)}) {
        std::vector<double> once;
        once.reserve(intensities.size());
        double sum = 0;
        for (const Vector3d &intensity : intensities)
            sum += weights.dot(intensity);
        for (const Vector3d &intensity : intensities)
            once.push_back(weights.dot(intensity) / sum);
        std::vector<double> twice;
        std::vector<double> inverse;
        std::vector<double> byNumber;
        for (const double p : once) {
            twice.push_back(p * p);
            inverse.push_back(1 / p);
            byNumber.push_back(p * static_cast<double>(lights.size()));
        }
        mistakes.push_back(weighted("ems.pick_pdf_forgotten", lights, once));
        mistakes.push_back(weighted("ems.pick_pdf_multiplied", lights, twice));
        mistakes.push_back(weighted("ems.pick_pdf_twice", lights, inverse));
        mistakes.push_back(weighted("importance.not_divided", lights, byNumber));
        for (std::size_t i = 0; i < lights.size(); ++i)
            alone("ems.light_chosen_once", i, inverse[i]);
    }
    for (std::size_t i = 0; i < lights.size(); ++i) {
        alone("ems.light_left_out", i, 1);
        alone("ems.light_chosen_once", i, static_cast<double>(lights.size()));
        std::vector<double> weights(lights.size(), 1);
        weights[i] = 0;
        mistakes.push_back(weighted("ems.light_left_out", lights, weights));
    }
    return mistakes;
}

} // namespace grader
