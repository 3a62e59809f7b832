// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include <window/color_map.h>

namespace window {

namespace {

struct Rgb {
    double red, green, blue;
};

/// Viridis of matplotlib (CC0), every 32nd of its 256 colours and the last one.
constexpr std::array<Rgb, 9> kViridis{{{0.267, 0.005, 0.329},
                                       {0.279, 0.175, 0.483},
                                       {0.229, 0.322, 0.546},
                                       {0.173, 0.449, 0.558},
                                       {0.128, 0.567, 0.551},
                                       {0.158, 0.684, 0.502},
                                       {0.369, 0.789, 0.383},
                                       {0.678, 0.864, 0.190},
                                       {0.993, 0.906, 0.144}}};
constexpr std::array<Rgb, 5> kDiverging{{{0.02, 0.25, 0.55},
                                         {0.45, 0.68, 0.87},
                                         {0.97, 0.97, 0.97},
                                         {0.98, 0.65, 0.36},
                                         {0.62, 0.22, 0.02}}};

template <std::size_t n>
std::uint32_t interpolate(const std::array<Rgb, n> &colors, double t) {
    if (std::isnan(t))
        return kNotANumberColor;
    const double place = std::clamp(t, 0.0, 1.0) * static_cast<double>(n - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(place), n - 2);
    const double f = place - static_cast<double>(i);
    const Rgb &a = colors.at(i);
    const Rgb &b = colors.at(i + 1);
    return packColor(a.red + f * (b.red - a.red), a.green + f * (b.green - a.green),
                     a.blue + f * (b.blue - a.blue));
}

} // namespace

std::uint32_t packColor(double red, double green, double blue, double alpha) {
    const auto byte = [](double x) {
        return static_cast<std::uint32_t>(std::lround(std::clamp(x, 0.0, 1.0) * 255.0));
    };
    return byte(red) | byte(green) << 8U | byte(blue) << 16U | byte(alpha) << 24U;
}

std::uint32_t viridis(double t) {
    return interpolate(kViridis, t);
}

std::uint32_t diverging(double t) {
    return interpolate(kDiverging, (t + 1.0) / 2.0);
}

} // namespace window
