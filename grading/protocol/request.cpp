// SPDX-License-Identifier: MIT
#include <protocol/request.h>

#include <limits>
#include <stdexcept>

namespace protocol {

namespace {

struct WarpShape {
    const char *id;
    std::uint32_t dimension;
};

constexpr WarpShape kWarps[] = {
    {"square", kPlanarDimension},
    {"tent", kPlanarDimension},
    {"disk", kPlanarDimension},
    {"triangle", kPlanarDimension},
    {"sphere", kDirectionDimension},
    {"hemisphere", kDirectionDimension},
    {"cosine_hemisphere", kDirectionDimension},
    {"beckmann", kDirectionDimension},
};

constexpr std::uint32_t kSampleSize = 2;
constexpr std::uint32_t kPointSize = 3;
constexpr std::uint32_t kEmitterEvalInput = 11;
constexpr std::uint32_t kRaySize = 6;
constexpr std::uint32_t kFilmPointSize = 2;

/// Rows of `values`, each of `width` floats.
std::size_t rowsOf(const Request &request, std::uint32_t width) {
    if (request.values.size() % width != 0)
        throw std::invalid_argument("Request::resultSize: values has " +
                                    std::to_string(request.values.size()) +
                                    " floats, not a multiple of " + std::to_string(width));
    return request.values.size() / width;
}

std::size_t times(std::size_t a, std::size_t b) {
    if (b != 0 && a > std::numeric_limits<std::uint32_t>::max() / b)
        throw std::invalid_argument("Request::resultSize: the answer would be too large");
    return a * b;
}

} // namespace

std::uint32_t warpDimension(const std::string &id) {
    for (const WarpShape &warp : kWarps) {
        if (id == warp.id)
            return warp.dimension;
    }
    throw std::invalid_argument("there is no warp \"" + id + "\"");
}

std::size_t Request::resultSize() const {
    switch (op) {
    case Op::WarpSample:
        return times(rowsOf(*this, kSampleSize), warpDimension(text));
    case Op::WarpDensity:
        return rowsOf(*this, warpDimension(text));
    case Op::MeshSample:
        return times(rowsOf(*this, kSampleSize), kMeshSampleSize);
    case Op::MeshDensity:
        return rowsOf(*this, kPointSize);
    case Op::EmitterSample:
        return times(rowsOf(*this, kEmitterSampleInput), kEmitterSampleSize);
    case Op::EmitterEval:
        return times(rowsOf(*this, kEmitterEvalInput), kEmitterEvalSize);
    case Op::EmitterPick:
        return times(values.size(), kEmitterPickSize);
    case Op::Radiance:
        return times(times(rowsOf(*this, kRaySize), repeats), 3);
    case Op::Image:
        return times(times(values.size(), repeats), 3);
    case Op::Film:
        return times(times(rowsOf(*this, kFilmPointSize), repeats), 3);
    case Op::SceneFacts:
        return kSceneFactsSize;
    }
    throw std::invalid_argument("Request::resultSize: unknown op");
}

} // namespace protocol
