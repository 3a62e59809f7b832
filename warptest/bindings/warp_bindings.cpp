// SPDX-License-Identifier: MIT
#include <nori/vector.h>
#include <nori/warp.h>

#include <stdexcept>
#include <string>

#include <bindings/warp_bindings.h>

namespace bindings {

namespace {

using battery::Output;
using nori::Point2f;
using nori::Vector3f;
using nori::Warp;

struct Binding {
    std::string_view id;
    Output (*warp)(const Point2f &u, float a);
    float (*density)(const Output &p, float a);
};

Output toOutput(const Point2f &p) {
    return {p.x(), p.y(), 0.0F};
}

Output toOutput(const Vector3f &v) {
    return {v.x(), v.y(), v.z()};
}

template <Point2f (*warp)(const Point2f &), float (*density)(const Point2f &)>
constexpr Binding planar(std::string_view id) {
    return {id, [](const Point2f &u, float) { return toOutput(warp(u)); },
            [](const Output &p, float) {
                return density(Point2f(p.x, p.y));
            }};
}

template <Vector3f (*warp)(const Point2f &), float (*density)(const Vector3f &)>
constexpr Binding directional(std::string_view id) {
    return {id, [](const Point2f &u, float) { return toOutput(warp(u)); },
            [](const Output &p, float) {
                return density(Vector3f(p.x, p.y, p.z));
            }};
}

constexpr Binding kBindings[] = {
    planar<&Warp::squareToUniformSquare, &Warp::squareToUniformSquarePdf>("square"),
    planar<&Warp::squareToTent, &Warp::squareToTentPdf>("tent"),
    planar<&Warp::squareToUniformDisk, &Warp::squareToUniformDiskPdf>("disk"),
    planar<&Warp::squareToUniformTriangle, &Warp::squareToUniformTrianglePdf>("triangle"),
    directional<&Warp::squareToUniformSphere, &Warp::squareToUniformSpherePdf>("sphere"),
    directional<&Warp::squareToUniformHemisphere, &Warp::squareToUniformHemispherePdf>(
        "hemisphere"),
    directional<&Warp::squareToCosineHemisphere, &Warp::squareToCosineHemispherePdf>(
        "cosine_hemisphere"),
    {"beckmann", [](const Point2f &u, float a) { return toOutput(Warp::squareToBeckmann(u, a)); },
     [](const Output &p, float a) {
         return Warp::squareToBeckmannPdf(Vector3f(p.x, p.y, p.z), a);
     }}};

const Binding &find(std::string_view id) {
    for (const Binding &binding : kBindings) {
        if (binding.id == id) {
            return binding;
        }
    }
    throw std::invalid_argument("there is no warp \"" + std::string(id) + "\" in <nori/warp.h>");
}

} // namespace

std::vector<Output> callWarp(std::string_view id, std::span<const battery::Input> inputs,
                             double a) {
    const Binding &binding = find(id);
    std::vector<Output> outputs;
    outputs.reserve(inputs.size());
    for (const battery::Input &input : inputs) {
        outputs.push_back(binding.warp(Point2f(input.u, input.v), static_cast<float>(a)));
    }
    return outputs;
}

std::vector<float> callDensity(std::string_view id, std::span<const Output> points, double a) {
    const Binding &binding = find(id);
    std::vector<float> densities;
    densities.reserve(points.size());
    for (const Output &point : points) {
        densities.push_back(binding.density(point, static_cast<float>(a)));
    }
    return densities;
}

} // namespace bindings
