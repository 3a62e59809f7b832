// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include <preview/image_summary.h>

namespace preview {

namespace {

constexpr double kDarkest = 0.01; ///< added to squares of radiances that are divided by

/// Finite values of a channel.
struct Range {
    double sum = 0;
    size_t count = 0;
    double smallest = 0;
    double largest = 0;

    void add(double value) {
        smallest = count == 0 ? value : std::min(smallest, value);
        largest = count == 0 ? value : std::max(largest, value);
        sum += value;
        ++count;
    }
};

bool hasAny(const nori::Color3f &value, bool (*property)(float)) {
    return property(value[0]) || property(value[1]) || property(value[2]);
}

bool isNotANumber(float x) {
    return std::isnan(x);
}

bool isInfinite(float x) {
    return std::isinf(x);
}

bool isNegative(float x) {
    return x < 0;
}

} // namespace

bool isFaulty(const nori::Color3f &value) {
    return hasAny(value, isNotANumber) || hasAny(value, isInfinite) || hasAny(value, isNegative);
}

ImageSummary summarize(const nori::Bitmap &image) {
    ImageSummary summary;
    std::array<Range, 3> ranges;
    for (int y = 0; y < image.rows(); ++y) {
        for (int x = 0; x < image.cols(); ++x) {
            const nori::Color3f &value = image.coeff(y, x);
            for (int c = 0; c < 3; ++c) {
                if (std::isfinite(value[c]))
                    ranges[static_cast<size_t>(c)].add(static_cast<double>(value[c]));
            }
            if (!isFaulty(value))
                continue;
            summary.notANumber += hasAny(value, isNotANumber) ? 1 : 0;
            summary.infinite += hasAny(value, isInfinite) ? 1 : 0;
            summary.negative += hasAny(value, isNegative) ? 1 : 0;
            if (summary.faulty.size() < kListedPixels)
                summary.faulty.emplace_back(x, y);
        }
    }
    for (size_t c = 0; c < 3; ++c) {
        summary.mean[c] = ranges[c].sum / static_cast<double>(std::max<size_t>(ranges[c].count, 1));
        summary.smallest[c] = ranges[c].smallest;
        summary.largest[c] = ranges[c].largest;
    }
    return summary;
}

std::optional<ImageError> measureError(const nori::Bitmap &image, const nori::Bitmap &reference) {
    if (image.rows() != reference.rows() || image.cols() != reference.cols())
        return std::nullopt;
    double squares = 0;
    double relative = 0;
    double sum = 0;
    double referenceSum = 0;
    double count = 0;
    for (Eigen::Index i = 0; i < image.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const auto x = static_cast<double>(image.data()[i][c]);
            const auto r = static_cast<double>(reference.data()[i][c]);
            if (!std::isfinite(x) || !std::isfinite(r))
                continue;
            squares += (x - r) * (x - r);
            relative += (x - r) * (x - r) / (r * r + kDarkest);
            sum += x;
            referenceSum += r;
            ++count;
        }
    }
    count = std::max(count, 1.0);
    ImageError error;
    error.rmse = std::sqrt(squares / count);
    error.relative = relative / count;
    error.bias = referenceSum != 0 ? sum / referenceSum - 1 : 0.0;
    return error;
}

std::vector<std::string> describe(const ImageSummary &summary) {
    const auto line = [](const char *name, const std::array<double, 3> &values) {
        return fmt::format("{:5} {:9.4g} {:9.4g} {:9.4g}", name, values[0], values[1], values[2]);
    };
    return {line("mean", summary.mean), line("min", summary.smallest), line("max", summary.largest),
            fmt::format("pixels: {} NaN, {} infinite, {} negative", summary.notANumber,
                        summary.infinite, summary.negative)};
}

std::vector<std::string> describe(const ImageError &error) {
    return {fmt::format("RMSE {:.4g}", error.rmse), fmt::format("relMSE {:.4g}", error.relative),
            fmt::format("mean {:+.3g} %", 100 * error.bias)};
}

} // namespace preview
