// SPDX-License-Identifier: MIT
#include "verification.h"

#include <grader/error.h>
#include <grader/images/comparison.h>
#include <statistics/tile_welch.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace grader {

namespace {

constexpr double kPower = 0.999;
constexpr std::size_t kChannels = 3;

/// The moments of an image, and how it is laid out.
struct Moments {
    int width = 0;
    int height = 0;
    std::vector<ChannelMoments> channels;

    statistics::MomentImage channel(std::size_t c) const {
        return {width, height, channels[c].pixels};
    }
};

Moments readMoments(const protocol::Image &image) {
    auto channels = momentsOf(image);
    if (!channels)
        throw GraderError("an image has no moments; `nori --moments` writes them");
    return {image.width, image.height, std::move(*channels)};
}

Moments pool(const Moments &a, const Moments &b) {
    if (a.width != b.width || a.height != b.height)
        throw GraderError("the halves of a reference have different sizes");
    Moments all{a.width, a.height, {}};
    for (std::size_t c = 0; c < kChannels; ++c)
        all.channels.push_back(merged(a.channels[c], b.channels[c]));
    return all;
}

/// Adds one channel's tile test.
void addTiles(Agreement &result, const statistics::MomentImage &render,
              const statistics::MomentImage &reference) {
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

void addScale(Agreement &result, const statistics::MomentImage &render,
              const statistics::MomentImage &a, const statistics::MomentImage &b, double level) {
    statistics::TileWelchConfig config;
    config.significance = level;
    config.power = kPower;
    result.hasScale = true;
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

Accord accordOf(const Agreement &agreement, double level) {
    if (!agreement.isTested)
        return Accord::TooSkewed;
    if (agreement.pValue < level)
        return Accord::Different;
    return agreement.hasScale && agreement.scaleBound > kScaleAtWorst ? Accord::TooNoisy
                                                                      : Accord::Alike;
}

Agreement compareWithReference(const protocol::Image &render,
                               const std::array<protocol::Image, 2> &halves, double level) {
    const Moments mine = readMoments(render);
    const Moments a = readMoments(halves[0]);
    const Moments b = readMoments(halves[1]);
    const Moments both = pool(a, b);
    Agreement result;
    try {
        for (std::size_t c = 0; c < kChannels; ++c) {
            addTiles(result, mine.channel(c), both.channel(c));
            addScale(result, mine.channel(c), a.channel(c), b.channel(c),
                     level / static_cast<double>(kChannels));
        }
    } catch (const std::invalid_argument &error) {
        throw GraderError(error.what());
    }
    return result;
}

Agreement compareHalves(const std::array<protocol::Image, 2> &halves) {
    const Moments a = readMoments(halves[0]);
    const Moments b = readMoments(halves[1]);
    Agreement result;
    try {
        for (std::size_t c = 0; c < kChannels; ++c)
            addTiles(result, a.channel(c), b.channel(c));
    } catch (const std::invalid_argument &error) {
        throw GraderError(error.what());
    }
    return result;
}

} // namespace grader
