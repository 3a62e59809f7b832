// SPDX-License-Identifier: MIT
#include "verification.h"

#include <grader/error.h>
#include <statistics/tile_welch.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace grader {

namespace {

using statistics::MomentSummary;

constexpr double kPower = 0.999;
constexpr std::array<const char *, 3> kChannels = {"R", "G", "B"};

/// One channel of an image.
struct Moments {
    int width = 0;
    int height = 0;
    std::vector<MomentSummary> pixels;

    operator statistics::MomentImage() const { return {width, height, pixels}; } // NOLINT
};

Moments momentsOf(const protocol::Image &image, const std::string &channel) {
    const protocol::Channel *const count = image.channel("count.Y");
    const protocol::Channel *const mean = image.channel("mean." + channel);
    const protocol::Channel *const variance = image.channel("variance." + channel);
    const protocol::Channel *const third = image.channel("third." + channel);
    if (count == nullptr || mean == nullptr || variance == nullptr || third == nullptr)
        throw GraderError("an image has no moments; `nori --moments` writes them");
    Moments moments{image.width, image.height, {}};
    for (std::size_t i = 0; i < mean->values.size(); ++i)
        moments.pixels.push_back(
            {static_cast<double>(count->values[i]), static_cast<double>(mean->values[i]),
             static_cast<double>(variance->values[i]), static_cast<double>(third->values[i])});
    return moments;
}

/// Moments of two samples together. \see Pebay 2008, eq. 2.1 and 2.2
MomentSummary pool(const MomentSummary &a, const MomentSummary &b) {
    const double count = a.count + b.count;
    const double delta = b.mean - a.mean;
    const auto sum2 = [](const MomentSummary &s) {
        return s.variance * (s.count - 1);
    };
    const auto sum3 = [](const MomentSummary &s) {
        return s.thirdCentral * (s.count - 1) * (s.count - 2) / s.count;
    };
    const double all2 = sum2(a) + sum2(b) + delta * delta * a.count * b.count / count;
    const double all3 =
        sum3(a) + sum3(b) +
        std::pow(delta, 3) * a.count * b.count * (a.count - b.count) / (count * count) +
        3 * delta * (a.count * sum2(b) - b.count * sum2(a)) / count;
    return {count, a.mean + delta * b.count / count, all2 / (count - 1),
            all3 * count / ((count - 1) * (count - 2))};
}

Moments pool(const Moments &a, const Moments &b) {
    if (a.pixels.size() != b.pixels.size())
        throw GraderError("the halves of a reference have different sizes");
    Moments all{a.width, a.height, {}};
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        all.pixels.push_back(pool(a.pixels[i], b.pixels[i]));
    return all;
}

/// Adds one channel's tile test.
void addTiles(Agreement &result, const Moments &render, const Moments &reference) {
    const int side = std::max(render.width, render.height);
    statistics::TileWelchConfig config;
    statistics::TileWelchResult tiles = tileWelchTest(render, reference, config);
    while (!tiles.gateMet && config.tileSize < side) {
        config.tileSize *= 2;
        tiles = tileWelchTest(render, reference, config);
    }
    result.tileSize = std::max(result.tileSize, config.tileSize);
    result.isTested = result.isTested && tiles.gateMet;
    result.pValue = std::min(result.pValue, std::min(1.0, 3.0 * tiles.pValue));
}

void addScale(Agreement &result, const Moments &render, const Moments &a, const Moments &b,
              double level) {
    statistics::TileWelchConfig config;
    config.significance = level;
    config.power = kPower;
    const statistics::ScaleEstimate scale = estimateScale(render, a, b, config);
    if (std::abs(scale.beta) > std::abs(result.scale))
        result.scale = scale.beta;
    result.scaleBound = std::max(result.scaleBound, scale.bound);
    result.scaleMde = std::max(result.scaleMde, scale.mde);
}

} // namespace

std::vector<std::string> independentAlgorithms(const SceneFile &scene) {
    if (!scene.hasPointLight)
        return {"direct_mats", "direct_mis"};
    return {scene.integrator == "direct_whitted" ? "direct_ems" : "direct_whitted", "direct_mis"};
}

Agreement compareWithReference(const protocol::Image &render,
                               const std::array<protocol::Image, 2> &halves, double level) {
    Agreement result;
    try {
        for (const char *channel : kChannels) {
            const Moments mine = momentsOf(render, channel);
            const Moments a = momentsOf(halves[0], channel);
            const Moments b = momentsOf(halves[1], channel);
            addTiles(result, mine, pool(a, b));
            addScale(result, mine, a, b, level / 3.0);
        }
    } catch (const std::invalid_argument &error) {
        throw GraderError(error.what());
    }
    return result;
}

Agreement compareHalves(const std::array<protocol::Image, 2> &halves) {
    Agreement result;
    try {
        for (const char *channel : kChannels)
            addTiles(result, momentsOf(halves[0], channel), momentsOf(halves[1], channel));
    } catch (const std::invalid_argument &error) {
        throw GraderError(error.what());
    }
    return result;
}

} // namespace grader
