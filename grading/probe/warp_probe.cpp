// SPDX-License-Identifier: MIT
#include <nori/vector.h>
#include <nori/warp.h>
#include <probe/probe.h>

#include <stdexcept>

namespace probe {

namespace {

using nori::Point2f;
using nori::Vector3f;
using nori::Warp;

/// One warp: only the functions of the one that is asked for are ever called.
struct WarpRow {
    const char *id;
    void (*sample)(const Point2f &u, float parameter, Values &out);
    float (*density)(const float *point, float parameter);
};

template <auto Function>
void sampleOf(const Point2f &u, float, Values &out) {
    append(out, Function(u));
}

template <float (*Function)(const Point2f &)>
float planarDensity(const float *point, float) {
    return Function(Point2f(point[0], point[1]));
}

template <float (*Function)(const Vector3f &)>
float directionDensity(const float *point, float) {
    return Function(Vector3f(point[0], point[1], point[2]));
}

void sampleBeckmann(const Point2f &u, float alpha, Values &out) {
    append(out, Warp::squareToBeckmann(u, alpha));
}

float beckmannDensity(const float *point, float alpha) {
    return Warp::squareToBeckmannPdf(Vector3f(point[0], point[1], point[2]), alpha);
}

const WarpRow kWarps[] = {
    {"square", sampleOf<&Warp::squareToUniformSquare>,
     planarDensity<&Warp::squareToUniformSquarePdf>},
    {"tent", sampleOf<&Warp::squareToTent>, planarDensity<&Warp::squareToTentPdf>},
    {"disk", sampleOf<&Warp::squareToUniformDisk>, planarDensity<&Warp::squareToUniformDiskPdf>},
    {"triangle", sampleOf<&Warp::squareToUniformTriangle>,
     planarDensity<&Warp::squareToUniformTrianglePdf>},
    {"sphere", sampleOf<&Warp::squareToUniformSphere>,
     directionDensity<&Warp::squareToUniformSpherePdf>},
    {"hemisphere", sampleOf<&Warp::squareToUniformHemisphere>,
     directionDensity<&Warp::squareToUniformHemispherePdf>},
    {"cosine_hemisphere", sampleOf<&Warp::squareToCosineHemisphere>,
     directionDensity<&Warp::squareToCosineHemispherePdf>},
    {"beckmann", sampleBeckmann, beckmannDensity},
};

const WarpRow &findWarp(const std::string &id) {
    for (const WarpRow &warp : kWarps) {
        if (id == warp.id)
            return warp;
    }
    throw std::invalid_argument("there is no warp \"" + id + "\"");
}

} // namespace

Values answerWarp(const protocol::Request &request) {
    const WarpRow &warp = findWarp(request.text);
    Values values;
    values.reserve(request.resultSize());
    if (request.op == protocol::Op::WarpSample) {
        for (std::size_t i = 0; i + 1 < request.values.size(); i += 2)
            warp.sample(Point2f(request.values[i], request.values[i + 1]), request.parameter,
                        values);
    } else {
        const std::size_t dimension = protocol::warpDimension(request.text);
        for (std::size_t i = 0; i + dimension <= request.values.size(); i += dimension)
            values.push_back(warp.density(&request.values[i], request.parameter));
    }
    return values;
}

} // namespace probe
