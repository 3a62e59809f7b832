// SPDX-License-Identifier: MIT
#pragma once

#include <grader/checks/radiance_samples.h>
#include <statistics/random.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace calibration {

constexpr int kSide = 32;                              ///< pixels
constexpr std::size_t kPixels = kSide * kSide;         ///< of an image
constexpr int kTileSize = 8;                           ///< pixels
constexpr std::size_t kSamples = std::size_t{1} << 12; ///< recorded per pixel

/// Samples of Li through every pixel of a scene, from which any number of runs is drawn: the law of
/// a run is then that of the recorded samples, fireflies and all, and both sides have it exactly.
class Recording {
public:
    /// Fills the template with `seed` and renders it in this process.
    /// \param integrator  instead of the template's
    Recording(const std::string &scene, std::uint64_t seed,
              const std::string &integrator = "direct_ems");

    /// Changes every sample: (pixel, color of three floats).
    void plant(const std::function<void(std::size_t, float *)> &change);

    /// Moments of `count` samples per pixel, drawn with replacement.
    grader::RadianceMoments draw(int count, statistics::Random &random) const;

    /// The samples themselves, as a probe would answer for these pixels.
    std::vector<float> samples(const std::vector<float> &pixels, std::uint32_t count,
                               statistics::Random &random) const;

    /// Mean of the recorded samples of each pixel: the truth of everything that is drawn.
    std::vector<double> means(std::size_t channel) const;

private:
    std::vector<float> m_values; ///< shape [kPixels, kSamples, 3]
};

} // namespace calibration
