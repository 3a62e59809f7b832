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

Point2f planar(const float *point) {
    return Point2f(point[0], point[1]);
}

Vector3f direction(const float *point) {
    return Vector3f(point[0], point[1], point[2]);
}

// Calls rather than addresses of functions: a submission's header may overload them, or take the
// argument by value.
const WarpRow kWarps[] = {
    {"square",
     [](const Point2f &u, float, Values &out) {
         probe::append(out, Warp::squareToUniformSquare(u));
     },
     [](const float *x, float) -> float {
         return Warp::squareToUniformSquarePdf(planar(x));
     }},
    {"tent",
     [](const Point2f &u, float, Values &out) { probe::append(out, Warp::squareToTent(u)); },
     [](const float *x, float) -> float {
         return Warp::squareToTentPdf(planar(x));
     }},
    {"disk",
     [](const Point2f &u, float, Values &out) { probe::append(out, Warp::squareToUniformDisk(u)); },
     [](const float *x, float) -> float {
         return Warp::squareToUniformDiskPdf(planar(x));
     }},
    {"triangle",
     [](const Point2f &u, float, Values &out) {
         probe::append(out, Warp::squareToUniformTriangle(u));
     },
     [](const float *x, float) -> float {
         return Warp::squareToUniformTrianglePdf(planar(x));
     }},
    {"sphere",
     [](const Point2f &u, float, Values &out) {
         probe::append(out, Warp::squareToUniformSphere(u));
     },
     [](const float *x, float) -> float {
         return Warp::squareToUniformSpherePdf(direction(x));
     }},
    {"hemisphere",
     [](const Point2f &u, float, Values &out) {
         probe::append(out, Warp::squareToUniformHemisphere(u));
     },
     [](const float *x, float) -> float {
         return Warp::squareToUniformHemispherePdf(direction(x));
     }},
    {"cosine_hemisphere",
     [](const Point2f &u, float, Values &out) {
         probe::append(out, Warp::squareToCosineHemisphere(u));
     },
     [](const float *x, float) -> float {
         return Warp::squareToCosineHemispherePdf(direction(x));
     }},
    {"beckmann",
     [](const Point2f &u, float alpha, Values &out) {
         probe::append(out, Warp::squareToBeckmann(u, alpha));
     },
     [](const float *x, float alpha) -> float {
         return Warp::squareToBeckmannPdf(direction(x), alpha);
     }},
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
