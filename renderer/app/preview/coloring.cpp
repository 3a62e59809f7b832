// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <preview/coloring.h>
#include <preview/image_summary.h>
#include <window/color_map.h>

namespace preview {

namespace {

constexpr double kDarkest = 0.01; ///< radiance below which differences are no longer relative

std::uint32_t byteOf(float srgb) {
    const float value = 255.0f * srgb;
    return value > 0.0f ? static_cast<std::uint32_t>(std::min(value, 255.0f)) : 0U;
}

} // namespace

std::uint32_t displayColor(const nori::Color3f &value, bool markFaulty) {
    if (markFaulty && isFaulty(value))
        return window::kNotANumberColor;
    const nori::Color3f srgb = value.toSRGB();
    return byteOf(srgb[0]) | byteOf(srgb[1]) << 8U | byteOf(srgb[2]) << 16U | 0xff000000U;
}

double signedDifference(const nori::Color3f &value, const nori::Color3f &reference) {
    const auto x = static_cast<double>(value.mean());
    const auto r = static_cast<double>(reference.mean());
    if (!std::isfinite(x) || !std::isfinite(r))
        return std::nan("");
    return (x - r) / (std::abs(r) + kDarkest);
}

std::vector<std::uint32_t> colorize(const nori::Bitmap &image, const nori::Bitmap *reference,
                                    const Look &look) {
    const View view = reference == nullptr ? View::Image : look.view;
    const double factor = std::exp2(look.exposure);
    const auto split =
        static_cast<Eigen::Index>(std::lround(look.split * static_cast<double>(image.cols())));
    std::vector<std::uint32_t> colors;
    colors.reserve(static_cast<size_t>(image.size()));
    for (Eigen::Index y = 0; y < image.rows(); ++y) {
        for (Eigen::Index x = 0; x < image.cols(); ++x) {
            if (view == View::Difference) {
                colors.push_back(window::diverging(
                    factor * signedDifference(image.coeff(y, x), reference->coeff(y, x))));
                continue;
            }
            const bool other = view == View::Reference || (view == View::Split && x >= split);
            const nori::Color3f value = other ? reference->coeff(y, x) : image.coeff(y, x);
            colors.push_back(displayColor(value * static_cast<float>(factor), look.markFaulty));
        }
    }
    return colors;
}

nori::Bitmap resized(const nori::Bitmap &image, Eigen::Index rows, Eigen::Index columns) {
    nori::Bitmap result(nori::Vector2i(static_cast<int>(columns), static_cast<int>(rows)));
    for (Eigen::Index y = 0; y < rows; ++y) {
        for (Eigen::Index x = 0; x < columns; ++x)
            result.coeffRef(y, x) = image.coeff((2 * y + 1) * image.rows() / (2 * rows),
                                                (2 * x + 1) * image.cols() / (2 * columns));
    }
    return result;
}

} // namespace preview
