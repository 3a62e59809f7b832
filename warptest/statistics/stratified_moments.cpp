// SPDX-License-Identifier: MIT
#include "stratified_moments.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace statistics {

namespace {

constexpr std::size_t kOrders = StratifiedMoments::kHighest + 1;
constexpr std::size_t kRow = 2 * StratifiedMoments::kHighest + 1;

/// Factors in V of one point: 1, sqrt2 cos(2 pi V), sqrt2 sin(2 pi V), ... by the recurrence of
/// Chebyshev, whose rounding error stays below 1e-14 at these orders.
std::array<double, kRow> angularFactors(double v) {
    const double angle = 2.0 * std::numbers::pi * v;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    std::array<double, kRow> factors{};
    factors[0] = 1.0;
    double cosine = std::numbers::sqrt2 * c;
    double sine = std::numbers::sqrt2 * s;
    for (std::size_t k = 1; k < kRow; k += 2) {
        factors[k] = cosine;
        factors[k + 1] = sine;
        const double next = cosine * c - sine * s;
        sine = sine * c + cosine * s;
        cosine = next;
    }
    return factors;
}

} // namespace

double StratifiedMoments::maxAbs() const {
    return std::fabs(values[indexOfMax()]);
}

std::size_t StratifiedMoments::indexOfMax() const {
    const auto largest = std::max_element(values.begin(), values.end(), [](double a, double b) {
        return std::fabs(a) < std::fabs(b);
    });
    return static_cast<std::size_t>(largest - values.begin());
}

StratifiedMoments stratifiedMoments(std::span<const double> u, std::span<const double> v) {
    if (u.size() != v.size() || u.empty()) {
        throw std::invalid_argument(
            "stratifiedMoments: u and v must have the same number of points, at least 1");
    }
    std::array<std::array<double, kRow>, kOrders> sums{};
    for (std::size_t i = 0; i < u.size(); ++i) {
        const std::array<double, kRow> angular = angularFactors(v[i]);
        const double c = std::cos(std::numbers::pi * u[i]);
        double previous = c; // cos(-x)
        double current = 1.0;
        for (std::size_t j = 0; j < kOrders; ++j) {
            for (std::size_t k = 0; k < kRow; ++k) {
                sums[j][k] += current * angular[k];
            }
            const double next = 2.0 * c * current - previous;
            previous = current;
            current = next;
        }
    }
    StratifiedMoments result;
    for (std::size_t j = 0; j < kOrders; ++j) {
        const double scale = (j == 0 ? 1.0 : std::numbers::sqrt2) / static_cast<double>(u.size());
        for (std::size_t k = j == 0 ? 1 : 0; k < kRow; ++k) {
            result.values[j * kRow + k - 1] = scale * sums[j][k];
        }
    }
    return result;
}

} // namespace statistics
