// SPDX-License-Identifier: MIT
#include "flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

namespace grader {

namespace {

using std::numbers::pi;

using Plane = std::vector<double>;
using Color = std::array<double, 3>;

struct Planes {
    int width = 0;
    int height = 0;
    std::array<Plane, 3> values;

    Color at(std::size_t i) const { return {values[0][i], values[1][i], values[2][i]}; }
};

// sRGB's primaries and white, IEC 61966-2-1; rows X, Y, Z.
constexpr double kXyz[3][3] = {{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
                               {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
                               {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}};

Color xyz(const Color &rgb) {
    Color result{};
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = kXyz[i][0] * rgb[0] + kXyz[i][1] * rgb[1] + kXyz[i][2] * rgb[2];
    return result;
}

const Color &white() {
    static const Color color = xyz({1, 1, 1});
    return color;
}

/// Opponent colours, linear in the light: YCxCz.
Color opponent(const Color &rgb) {
    const Color c = xyz(rgb);
    const double y = c[1] / white()[1];
    return {116 * y - 16, 500 * (c[0] / white()[0] - y), 200 * (y - c[2] / white()[2])};
}

/// X, Y, Z of an opponent colour, relative to white.
Color relativeXyz(const Color &opponentColor) {
    const double y = (opponentColor[0] + 16) / 116;
    return {y + opponentColor[1] / 500, y, y - opponentColor[2] / 200};
}

/// L*a*b*, with a* and b* as strong as the lightness lets them look (Hunt).
Color huntLab(const Color &relative) {
    constexpr double kDelta = 6.0 / 29;
    const auto f = [](double t) {
        return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0 / 29;
    };
    const double lightness = 116 * f(relative[1]) - 16;
    return {lightness, 0.01 * lightness * 500 * (f(relative[0]) - f(relative[1])),
            0.01 * lightness * 200 * (f(relative[1]) - f(relative[2]))};
}

/// Distance of large colour differences: city-block in lightness, Euclidean in colour.
double hyab(const Color &a, const Color &b) {
    return std::fabs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

Plane gaussian(double exponent, int radius) {
    Plane kernel;
    for (int i = -radius; i <= radius; ++i)
        kernel.push_back(std::exp(-exponent * i * i));
    return kernel;
}

/// Convolution with a separable kernel; the image goes on beyond its edge as at its edge.
Plane convolve(const Plane &plane, int width, int height, const Plane &kernelX,
               const Plane &kernelY) {
    const auto pass = [&](const Plane &from, const Plane &kernel, bool alongX) {
        const auto radius = static_cast<int>(kernel.size() / 2);
        Plane to(from.size(), 0.0);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                double sum = 0.0;
                auto weight = kernel.begin();
                for (int k = -radius; k <= radius; ++k, ++weight) {
                    const int px = alongX ? std::clamp(x + k, 0, width - 1) : x;
                    const int py = alongX ? y : std::clamp(y + k, 0, height - 1);
                    sum += *weight *
                           from[static_cast<std::size_t>(py) * static_cast<std::size_t>(width) +
                                static_cast<std::size_t>(px)];
                }
                to[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(x)] = sum;
            }
        }
        return to;
    };
    return pass(pass(plane, kernelX, true), kernelY, false);
}

Plane scaled(Plane plane, double factor) {
    for (double &value : plane)
        value *= factor;
    return plane;
}

double sum(const Plane &plane) {
    double total = 0.0;
    for (const double value : plane)
        total += value;
    return total;
}

/// What the eye resolves of one opponent channel: a sum of two Gaussians, normalised (eq. 1-4).
Plane contrastFiltered(const Planes &image, std::size_t channel, double pixelsPerDegree) {
    struct Term {
        double a, b;
    };

    constexpr std::array<std::array<Term, 2>, 3> kSensitivity{
        {{{{1, 0.0047}, {0, 1e-5}}}, {{{1, 0.0053}, {0, 1e-5}}}, {{{34.1, 0.04}, {13.5, 0.025}}}}};
    constexpr double kWidest = 0.04;
    const int radius =
        static_cast<int>(std::ceil(3 * std::sqrt(kWidest / (2 * pi * pi)) * pixelsPerDegree));
    Plane result(image.values[channel].size(), 0.0);
    double total = 0.0;
    for (const Term &term : kSensitivity[channel]) {
        if (term.a == 0)
            continue;
        const Plane kernel =
            gaussian(pi * pi / (term.b * pixelsPerDegree * pixelsPerDegree), radius);
        const double weight = term.a * std::sqrt(pi / term.b);
        const double mass = sum(kernel);
        total += weight * mass * mass;
        const Plane part =
            convolve(image.values[channel], image.width, image.height, kernel, kernel);
        for (std::size_t i = 0; i < result.size(); ++i)
            result[i] += weight * part[i];
    }
    return scaled(std::move(result), 1 / total);
}

/// Positive and negative parts of a kernel made to sum to 1 and -1.
Plane balanced(Plane kernel) {
    double positive = 0.0;
    double negative = 0.0;
    for (const double value : kernel)
        (value > 0 ? positive : negative) += value;
    for (double &value : kernel)
        value /= value > 0 ? positive : -negative;
    return kernel;
}

struct Features {
    Plane edges;
    Plane points;
};

/// Strength of edges and points in the lightness (section 4.3).
Features features(const Planes &image, double pixelsPerDegree) {
    const double deviation = 0.5 * 0.082 * pixelsPerDegree;
    const int radius = static_cast<int>(std::ceil(3 * deviation));
    const Plane smooth = gaussian(0.5 / (deviation * deviation), radius);
    Plane slope;
    Plane bend;
    for (int i = -radius; i <= radius; ++i) {
        const double g = std::exp(-0.5 / (deviation * deviation) * i * i);
        slope.push_back(-i * g);
        bend.push_back((i * i / (deviation * deviation) - 1) * g);
    }
    // The paper normalises the two-dimensional kernels; both are products with `smooth`.
    const Plane across = scaled(smooth, 1 / sum(smooth));
    slope = balanced(std::move(slope));
    bend = balanced(std::move(bend));
    Plane lightness = image.values[0];
    for (double &value : lightness)
        value = (value + 16) / 116;
    const auto strength = [&](const Plane &kernel) {
        const Plane x = convolve(lightness, image.width, image.height, kernel, across);
        const Plane y = convolve(lightness, image.width, image.height, across, kernel);
        Plane norm(x.size());
        for (std::size_t i = 0; i < x.size(); ++i)
            norm[i] = std::hypot(x[i], y[i]);
        return norm;
    };
    return {strength(slope), strength(bend)};
}

Planes opponentPlanes(const protocol::Image &image) {
    Planes planes{image.width, image.height, {}};
    const std::vector<float> &red = image.channel("R")->values;
    const std::vector<float> &green = image.channel("G")->values;
    const std::vector<float> &blue = image.channel("B")->values;
    const auto shown = [](float value) {
        return std::clamp(double{value}, 0.0, 1.0);
    };
    for (Plane &plane : planes.values)
        plane.resize(red.size());
    for (std::size_t i = 0; i < red.size(); ++i) {
        const Color color = opponent({shown(red[i]), shown(green[i]), shown(blue[i])});
        for (std::size_t c = 0; c < 3; ++c)
            planes.values[c][i] = color[c];
    }
    return planes;
}

/// What is left of an opponent colour after filtering, as a colour that a monitor can show.
Color shownLab(const Color &opponentColor) {
    // Inverse of kXyz.
    constexpr double kRgb[3][3] = {{3.241003275, -1.537398934, -0.498615861},
                                   {-0.969224334, 1.875930071, 0.041554224},
                                   {0.055639423, -0.204011202, 1.057148933}};
    const Color relative = relativeXyz(opponentColor);
    Color rgb{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j)
            rgb[i] += kRgb[i][j] * relative[j] * white()[j];
        rgb[i] = std::clamp(rgb[i], 0.0, 1.0);
    }
    Color result = xyz(rgb);
    for (std::size_t i = 0; i < 3; ++i)
        result[i] /= white()[i];
    return huntLab(result);
}

/// Colour difference in [0, 1] (section 4.2): small ones get most of the range.
double colorDifference(const Color &a, const Color &b) {
    constexpr double kExponent = 0.7;
    constexpr double kKnee = 0.4;
    constexpr double kKneeValue = 0.95;
    static const double largest =
        std::pow(hyab(shownLab(opponent({0, 1, 0})), shownLab(opponent({0, 0, 1}))), kExponent);
    const double difference = std::pow(hyab(shownLab(a), shownLab(b)), kExponent);
    const double knee = kKnee * largest;
    if (difference < knee)
        return kKneeValue / knee * difference;
    return kKneeValue + (difference - knee) / (largest - knee) * (1 - kKneeValue);
}

} // namespace

std::vector<float> flip(const protocol::Image &a, const protocol::Image &b,
                        double pixelsPerDegree) {
    const Planes images[2] = {opponentPlanes(a), opponentPlanes(b)};
    Planes filtered[2];
    Features found[2];
    for (int side = 0; side < 2; ++side) {
        for (std::size_t c = 0; c < 3; ++c)
            filtered[side].values[c] = contrastFiltered(images[side], c, pixelsPerDegree);
        found[side] = features(images[side], pixelsPerDegree);
    }
    std::vector<float> result(images[0].values[0].size());
    for (std::size_t i = 0; i < result.size(); ++i) {
        const double color = colorDifference(filtered[0].at(i), filtered[1].at(i));
        const double feature = std::max(std::fabs(found[0].edges[i] - found[1].edges[i]),
                                        std::fabs(found[0].points[i] - found[1].points[i]));
        const double featureDifference = std::sqrt(feature / std::numbers::sqrt2);
        result[i] = static_cast<float>(
            std::clamp(std::pow(color, 1 - std::min(1.0, featureDifference)), 0.0, 1.0));
    }
    return result;
}

} // namespace grader
