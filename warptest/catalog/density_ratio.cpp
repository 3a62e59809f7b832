// SPDX-License-Identifier: MIT
#include "density_ratio.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

namespace catalog {

namespace {

constexpr double kPi = std::numbers::pi;

struct NamedConstant {
    std::string_view name;
    double value;
};

constexpr auto kConstants = std::to_array<NamedConstant>({
    {"1", 1.0},
    {"2", 2.0},
    {"1/2", 0.5},
    {"4", 4.0},
    {"1/4", 0.25},
    {"8", 8.0},
    {"1/8", 0.125},
    {"pi", kPi},
    {"1/pi", 1.0 / kPi},
    {"2 pi", 2.0 * kPi},
    {"1/(2 pi)", 1.0 / (2.0 * kPi)},
    {"4 pi", 4.0 * kPi},
    {"1/(4 pi)", 1.0 / (4.0 * kPi)},
    {"pi/2", kPi / 2.0},
    {"2/pi", 2.0 / kPi},
    {"pi^2", kPi *kPi},
    {"1/pi^2", 1.0 / (kPi * kPi)},
    {"pi/3.14", kPi / 3.14},
    {"pi/3.1416", kPi / 3.1416},
    {"pi/3.1415", kPi / 3.1415},
    {"pi/3", kPi / 3.0},
    {"sqrt 2", std::numbers::sqrt2},
    {"1/sqrt 2", 1.0 / std::numbers::sqrt2},
    {"-1", -1.0},
});

struct NamedPower {
    std::string_view name;
    double exponent;
};

constexpr auto kAlphaPowers = std::to_array<NamedPower>({
    {"alpha", 1.0},
    {"1/alpha", -1.0},
    {"alpha^2", 2.0},
    {"1/alpha^2", -2.0},
    {"alpha^4", 4.0},
    {"1/alpha^4", -4.0},
});

bool isNear(double value, double target, double tolerance) {
    return std::fabs(value - target) <= tolerance * std::fabs(target);
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<long>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

} // namespace

std::string constantName(double constant, double a, double tolerance) {
    // The nearest of the plain numbers first: pi/3.1416 is within the tolerance of 1.
    const auto nearest = std::min_element(
        kConstants.begin(), kConstants.end(), [constant](const auto &x, const auto &y) {
            return std::fabs(constant / x.value - 1.0) < std::fabs(constant / y.value - 1.0);
        });
    if (isNear(constant, nearest->value, tolerance)) {
        return std::string(nearest->name);
    }
    if (a <= 0.0) {
        return {};
    }
    for (const NamedPower &power : kAlphaPowers) {
        const double alphaPower = std::pow(a, power.exponent);
        if (isNear(constant, alphaPower, tolerance)) {
            return std::string(power.name);
        }
        for (const NamedConstant &factor : kConstants) {
            if (isNear(constant, alphaPower * factor.value, tolerance)) {
                return std::string(factor.name) + " * " + std::string(power.name);
            }
        }
    }
    return {};
}

RatioLaw explainRatio(std::span<const RatioSample> samples, double a, double tolerance) {
    RatioLaw best;
    if (samples.empty()) {
        return best;
    }
    // The plain constant first: where cos is about 1 everywhere, it is the simplest explanation.
    for (const int power : {0, 1, -1, 2, -2, 3, -3, 4, -4}) {
        std::vector<double> constants;
        constants.reserve(samples.size());
        for (const RatioSample &sample : samples) {
            constants.push_back(sample.ratio / std::pow(sample.cosTheta, power));
        }
        const double constant = median(constants);
        const auto explained = std::count_if(constants.begin(), constants.end(), [=](double c) {
            return isNear(c, constant, tolerance);
        });
        if (static_cast<double>(explained) >= 0.99 * static_cast<double>(constants.size())) {
            best.found = true;
            best.constant = constant;
            best.cosinePower = power;
            best.constantName = constantName(constant, a);
            return best;
        }
    }
    return best;
}

} // namespace catalog
