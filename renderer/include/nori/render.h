// SPDX-License-Identifier: MIT
#pragma once

#include <nori/bitmap.h>

#include <array>
#include <atomic>
#include <functional>
#include <optional>

NORI_NAMESPACE_BEGIN

class ImageBlock;

struct RenderOptions {
    int samplesPerPixel = 0;                      ///< 0: what the scene's sampler says
    std::optional<int> seed;                      ///< nothing: the scene's sampler as it is
    int threads = 0;                              ///< 0: one per core
    bool moments = false;                         ///< fill in RenderResult::moments
    bool preprocess = true;                       ///< false: the integrator has done that before
    const std::atomic<bool> *cancelled = nullptr; ///< polled before every sample
    const std::atomic<bool> *paused = nullptr;    ///< as well; nothing happens until it is false
    // Called by one thread at a time.
    std::function<void(double fraction)> progress;
    std::function<void(const ImageBlock &)> blockBegun;
    std::function<void(const ImageBlock &)> blockDone; ///< not when it was cancelled
};

/// Of the unfiltered samples of one pixel (box filter), per channel; dropped samples do not count.
struct PixelMoments {
    double count = 0;
    std::array<double, 3> mean{};
    std::array<double, 3> variance{};     ///< unbiased; 0 below two samples
    std::array<double, 3> thirdCentral{}; ///< unbiased (Fisher's k3); 0 below three samples
};

struct RenderResult {
    Bitmap image;
    std::vector<PixelMoments> moments; ///< shape [rows, columns], row 0 on top; empty if not asked
    int samplesPerPixel = 0;
    size_t droppedSamples = 0; ///< negative or not finite
    bool complete = true;      ///< false: cancelled; pixels not reached are black
};

/// Renders in blocks on several threads, in Nori's order of samples. The result has the same bits
/// for any number of threads: every block has its own random numbers, and blocks are added up in a
/// fixed order.
/// \throws NoriException  if the image is empty or too large for the memory, or has no samples
RenderResult render(Scene &scene, const RenderOptions &options = RenderOptions());

NORI_NAMESPACE_END
