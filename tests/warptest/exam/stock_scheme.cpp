// SPDX-License-Identifier: MIT
#include "stock_scheme.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <pcg32.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

namespace warp_exam {

namespace {

using battery::Input;
using battery::Output;
using Integrand = std::function<double(double)>;

constexpr int kRows = 51;
constexpr int kSamplesPerCell = 1000;
constexpr double kEpsilon = 1e-6;
constexpr int kDepth = 6;
constexpr double kMinExpected = 5.0;
constexpr double kLevel = 0.01;
constexpr double kImpossible = 1e-5; ///< part of the samples that an empty cell may hold

double refine(const Integrand &f, double a, double b, double c, double fa, double fb, double fc,
              double whole, double epsilon, int depth) {
    const double d = 0.5 * (a + b);
    const double e = 0.5 * (b + c);
    const double fd = f(d);
    const double fe = f(e);
    const double h = c - a;
    const double left = h / 12.0 * (fa + 4.0 * fd + fb);
    const double right = h / 12.0 * (fb + 4.0 * fe + fc);
    const double sum = left + right;
    if (depth <= 0 || std::fabs(sum - whole) < 15.0 * epsilon) {
        return sum + (sum - whole) / 15.0;
    }
    return refine(f, a, d, b, fa, fd, fb, left, 0.5 * epsilon, depth - 1) +
           refine(f, b, e, c, fb, fe, fc, right, 0.5 * epsilon, depth - 1);
}

double simpson(const Integrand &f, double a, double c) {
    const double b = 0.5 * (a + c);
    const double fa = f(a);
    const double fb = f(b);
    const double fc = f(c);
    return refine(f, a, b, c, fa, fb, fc, (c - a) / 6.0 * (fa + 4.0 * fb + fc), kEpsilon, kDepth);
}

/// The grid of one warp: places in [0, 1]^2, points, and the area that 1 of a place stands for.
struct Grid {
    explicit Grid(const catalog::WarpEntry &target)
        : directions(target.dimension == 3),
          centred(target.id == "disk" || target.id == "tent"),
          columns(directions || target.id == "triangle" ? 2 * kRows : kRows),
          area(directions ? 4.0 * std::numbers::pi
               : centred  ? 4.0
                          : 1.0) {}

    [[nodiscard]] Output point(double x, double y) const {
        if (directions) {
            const double z = 2.0 * y - 1.0;
            const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
            const double phi = 2.0 * std::numbers::pi * x;
            return {static_cast<float>(r * std::cos(phi)), static_cast<float>(r * std::sin(phi)),
                    static_cast<float>(z)};
        }
        return centred ? Output{static_cast<float>(2.0 * x - 1.0),
                                static_cast<float>(2.0 * y - 1.0), 0.0F}
                       : Output{static_cast<float>(x), static_cast<float>(y), 0.0F};
    }

    [[nodiscard]] std::size_t cell(const Output &p) const {
        auto x = static_cast<double>(p.x);
        auto y = static_cast<double>(p.y);
        if (directions) {
            x = std::atan2(y, x) / (2.0 * std::numbers::pi);
            x = x < 0.0 ? x + 1.0 : x;
            y = 0.5 * static_cast<double>(p.z) + 0.5;
        } else if (centred) {
            x = 0.5 * x + 0.5;
            y = 0.5 * y + 0.5;
        }
        const auto index = [](double at, int count) {
            const double scaled = std::floor(at * count);
            return scaled > 0.0 ? std::min(static_cast<int>(std::min(scaled, 1e6)), count - 1) : 0;
        };
        return static_cast<std::size_t>(index(y, kRows) * columns + index(x, columns));
    }

    bool directions;
    bool centred;
    int columns;
    double area;
};

std::vector<double> countSamples(const Configuration &item, const Grid &grid) {
    pcg32 random;
    std::vector<Input> inputs(static_cast<std::size_t>(kRows * grid.columns * kSamplesPerCell));
    for (Input &input : inputs) { // g++ evaluates Point2f(next, next) from the right
        input.v = random.nextFloat();
        input.u = random.nextFloat();
    }
    std::vector<double> counts(static_cast<std::size_t>(kRows * grid.columns));
    for (const Output &output : item.warp(inputs)) {
        counts[grid.cell(output)] += 1.0;
    }
    return counts;
}

std::vector<double> integrateCells(const Configuration &item, const Grid &grid, double samples) {
    std::vector<double> expected;
    const double dx = 1.0 / grid.columns;
    const double dy = 1.0 / kRows;
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            const double mass = simpson(
                [&](double y) {
                    return simpson(
                        [&](double x) {
                            const Output at = grid.point(x, y);
                            return static_cast<double>(item.density({&at, 1}).front());
                        },
                        column * dx, (column + 1) * dx);
                },
                row * dy, (row + 1) * dy);
            expected.push_back(mass * grid.area * samples);
        }
    }
    return expected;
}

} // namespace

StockVerdict stockScheme(const Configuration &item) {
    const Grid grid(*item.target);
    const double samples = static_cast<double>(kRows) * grid.columns * kSamplesPerCell;
    const std::vector<double> observed = countSamples(item, grid);
    const std::vector<double> expected = integrateCells(item, grid, samples);
    std::vector<std::size_t> order(expected.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return expected[i] < expected[j]; });
    double statistic = 0.0;
    double pooledObserved = 0.0;
    double pooledExpected = 0.0;
    int degreesOfFreedom = 0;
    for (const std::size_t i : order) {
        if (expected[i] == 0.0) {
            if (observed[i] > kImpossible * samples) {
                return {};
            }
        } else if (expected[i] < kMinExpected ||
                   (pooledExpected > 0.0 && pooledExpected < kMinExpected)) {
            pooledObserved += observed[i];
            pooledExpected += expected[i];
        } else {
            const double difference = observed[i] - expected[i];
            statistic += difference * difference / expected[i];
            ++degreesOfFreedom;
        }
    }
    if (pooledExpected > 0.0 || pooledObserved > 0.0) {
        const double difference = pooledObserved - pooledExpected;
        statistic += difference * difference / pooledExpected;
        ++degreesOfFreedom;
    }
    --degreesOfFreedom;
    if (degreesOfFreedom <= 0 || !std::isfinite(statistic)) {
        return {};
    }
    // negative densities can make the statistic negative; the stock tool's law is 0 there
    const double pValue =
        1.0 - cdf(boost::math::chi_squared(degreesOfFreedom), std::max(0.0, statistic));
    return {pValue >= kLevel, pValue};
}

} // namespace warp_exam
