// SPDX-License-Identifier: MIT
#pragma once

#include <nori/parser.h>
#include <nori/render.h>
#include <nori/scene.h>
#include <statistics/tile_welch.h>

#include <filesystem/resolver.h>

#include <filesystem>
#include <string>
#include <vector>

namespace nori::test {

/// The moments of a render, one image per channel.
struct MomentRender {
    int width = 0;
    int height = 0;
    std::vector<statistics::MomentSummary> channels[3];

    statistics::MomentImage channel(int c) const { return {width, height, channels[c]}; }

    /// As if the radiance were `factor` times as high: a planted bias.
    MomentRender scaled(double factor) const {
        MomentRender result = *this;
        for (auto &pixels : result.channels) {
            for (auto &pixel : pixels) {
                pixel.mean *= factor;
                pixel.variance *= factor * factor;
                pixel.thirdCentral *= factor * factor * factor;
            }
        }
        return result;
    }
};

inline MomentRender renderMoments(Scene &scene, int spp, int seed) {
    RenderOptions options;
    options.samplesPerPixel = spp;
    options.seed = seed;
    options.moments = true;
    const RenderResult result = render(scene, options);
    MomentRender moments;
    moments.width = static_cast<int>(result.image.cols());
    moments.height = static_cast<int>(result.image.rows());
    for (const PixelMoments &pixel : result.moments) {
        for (size_t c = 0; c < 3; ++c)
            moments.channels[c].push_back(
                {pixel.count, pixel.mean[c], pixel.variance[c], pixel.thirdCentral[c]});
    }
    return moments;
}

/// \param file  below scenes/assignment-2
inline MomentRender renderScene(const std::string &file, const std::string &integrator,
                                const Vector2i &size, int spp, int seed) {
    const std::filesystem::path path =
        std::filesystem::path(NORI_SOURCE_DIR) / "scenes" / "assignment-2" / file;
    getFileResolver()->prepend(::filesystem::path(path.parent_path().string()));
    const std::unique_ptr<Scene> scene(
        static_cast<Scene *>(loadFromXML(path.string(), {size, integrator})));
    return renderMoments(*scene, spp, seed);
}

} // namespace nori::test
