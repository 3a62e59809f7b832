// SPDX-License-Identifier: MIT
#include "film_patches.h"

#include <statistics/random.h>

#include <algorithm>
#include <cmath>

namespace grader {

namespace {

/// The pixels whose samples count for a patch.
Patch grown(const Patch &patch, const PatchPlan &plan) {
    // Of pixel centres, half a pixel further than any sample of the pixel lies.
    const int reach = static_cast<int>(std::ceil(plan.film.radius));
    const int left = std::max(0, patch.x - reach);
    const int top = std::max(0, patch.y - reach);
    const int right = std::min(plan.width, patch.x + patch.width + reach);
    const int bottom = std::min(plan.height, patch.y + patch.height + reach);
    return {left, top, right - left, bottom - top};
}

/// What a patch's pixels have received so far.
class Film {
public:
    Film(const Patch &patch, const statistics::GaussianFilm &film)
        : m_patch(patch), m_film(film), m_sums(patch.pixels()) {}

    void put(float x, float y, const float *color) {
        const bool isValid =
            std::all_of(color, color + 3, [](float c) { return c >= 0 && std::isfinite(c); });
        if (!isValid)
            return;
        const double u = double{x} - 0.5 - m_patch.x; // from the centre of the first pixel
        const double v = double{y} - 0.5 - m_patch.y;
        const int left = std::max(0, static_cast<int>(std::ceil(u - m_film.radius)));
        const int top = std::max(0, static_cast<int>(std::ceil(v - m_film.radius)));
        const int right =
            std::min(m_patch.width - 1, static_cast<int>(std::floor(u + m_film.radius)));
        const int bottom =
            std::min(m_patch.height - 1, static_cast<int>(std::floor(v + m_film.radius)));
        for (int row = top; row <= bottom; ++row) {
            const double wy = m_film.weight(std::fabs(row - v));
            for (int column = left; column <= right; ++column) {
                const double weight = wy * m_film.weight(std::fabs(column - u));
                Sum &sum = m_sums[static_cast<std::size_t>(row) * m_patch.width + column];
                sum.weight += weight;
                for (std::size_t c = 0; c < 3; ++c)
                    sum.color[c] += weight * double{color[c]};
            }
        }
    }

    PatchPixels pixels() const {
        PatchPixels pixels(m_sums.size());
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            for (std::size_t c = 0; c < 3 && m_sums[i].weight > 0; ++c)
                pixels[i][c] = static_cast<float>(m_sums[i].color[c] / m_sums[i].weight);
        }
        return pixels;
    }

private:
    struct Sum {
        double weight = 0;
        std::array<double, 3> color{};
    };

    const Patch &m_patch;
    const statistics::GaussianFilm &m_film;
    std::vector<Sum> m_sums;
};

} // namespace

std::vector<Patch> spreadPatches(int width, int height, int wanted, int side, std::uint64_t seed) {
    constexpr int kGap = 4; ///< pixels between patches: twice the film's radius
    constexpr int kSmallest = 4;
    // As many square cells as are wanted, or as have room for a patch.
    const double cell = std::sqrt(static_cast<double>(width) * height / wanted);
    const int columns = std::clamp(static_cast<int>(std::lround(width / cell)), 1,
                                   std::max(1, width / (kSmallest + kGap)));
    const int rows = std::clamp(wanted / columns, 1, std::max(1, height / (kSmallest + kGap)));
    const int cellWidth = width / columns;
    const int cellHeight = height / rows;
    const int size = std::clamp(std::min(cellWidth, cellHeight) - kGap, 1, side);
    statistics::Random random(seed);
    std::vector<Patch> patches;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const auto place = [&](int room) {
                return room > 0 ? static_cast<int>(
                                      random.nextBelow(static_cast<std::uint64_t>(room) + 1))
                                : 0;
            };
            const int x = column * cellWidth + place(cellWidth - kGap - size);
            const int y = row * cellHeight + place(cellHeight - kGap - size);
            patches.push_back({x, y, std::min(size, width), std::min(size, height)});
        }
    }
    return patches;
}

std::vector<float> filmPoints(const PatchPlan &plan, int samples, std::uint64_t seed) {
    statistics::Random random(seed);
    std::vector<float> points;
    for (const Patch &patch : plan.patches) {
        const Patch area = grown(patch, plan);
        for (int y = area.y; y < area.y + area.height; ++y) {
            for (int x = area.x; x < area.x + area.width; ++x) {
                for (int s = 0; s < samples; ++s) {
                    const float u = random.nextFloat();
                    const float v = random.nextFloat();
                    points.push_back(static_cast<float>(x) + u);
                    points.push_back(static_cast<float>(y) + v);
                }
            }
        }
    }
    return points;
}

PatchImage develop(const PatchPlan &plan, const std::vector<float> &points,
                   const std::vector<float> &radiance, int samples) {
    PatchImage image;
    image.reserve(plan.patches.size());
    std::size_t at = 0;
    for (const Patch &patch : plan.patches) {
        Film film(patch, plan.film);
        const std::size_t count = grown(patch, plan).pixels() * static_cast<std::size_t>(samples);
        for (std::size_t i = 0; i < count; ++i, ++at)
            film.put(points[2 * at], points[2 * at + 1], radiance.data() + 3 * at);
        image.push_back(film.pixels());
    }
    return image;
}

PatchImage cutOut(const PatchPlan &plan, const protocol::Image &image) {
    const std::array<const protocol::Channel *, 3> channels = {
        image.channel("R"), image.channel("G"), image.channel("B")};
    PatchImage result;
    result.reserve(plan.patches.size());
    for (const Patch &patch : plan.patches) {
        PatchPixels pixels;
        pixels.reserve(patch.pixels());
        for (int y = patch.y; y < patch.y + patch.height; ++y) {
            for (int x = patch.x; x < patch.x + patch.width; ++x) {
                const std::size_t i = static_cast<std::size_t>(y) * image.width + x;
                pixels.push_back(
                    {channels[0]->values[i], channels[1]->values[i], channels[2]->values[i]});
            }
        }
        result.push_back(std::move(pixels));
    }
    return result;
}

double pngLevel(float linear) {
    const double value = std::clamp(double{linear}, 0.0, 1.0);
    const double srgb =
        value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055;
    return 255 * srgb;
}

} // namespace grader
