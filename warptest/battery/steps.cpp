// SPDX-License-Identifier: MIT
#include "steps.h"

#include <battery/unit_square.h>

#include <boost/sort/spreadsort/float_sort.hpp>

#include <algorithm>
#include <vector>

namespace battery {

namespace {

/// Coordinates within a smaller range are rounded too coarsely themselves: z of a narrow lobe.
constexpr double kSmallestRange = 0.01;

/// What a few operations in single precision may add up to.
constexpr double kRoundings = 8.0;

/// Gaps of continuous outputs, in expected ones, that are wider: one of exp(10).
constexpr double kWideGap = 10.0;

void lookAt(char coordinate, std::vector<double> values, StepResult &worst) {
    if (values.size() < 4) {
        return;
    }
    const std::size_t from = values.size() / 4;
    const std::size_t to = values.size() - 1 - from;
    // Only the middle half has to be in order, and by radix: sorting was a fifth of a grading.
    const auto first = values.begin() + static_cast<long>(from);
    const auto last = values.begin() + static_cast<long>(to);
    std::nth_element(values.begin(), first, values.end());
    std::nth_element(first, last, values.end());
    boost::sort::spreadsort::float_sort(first, last + 1);
    const double range = values[to] - values[from];
    if (!(range > kSmallestRange)) {
        return;
    }
    const double spacing = 1.0 / static_cast<double>(to - from);
    double gap = 0.0;
    double emptied = 0.0;
    for (std::size_t i = from; i < to; ++i) {
        const double step = (values[i + 1] - values[i]) / range;
        gap = std::max(gap, step);
        emptied += step > kWideGap * spacing ? step : 0.0;
    }
    if (gap > worst.gap) {
        worst.gap = gap;
        worst.coordinate = coordinate;
        worst.spacing = spacing;
        worst.emptied = emptied;
    }
}

} // namespace

StepResult judgeSteps(const catalog::WarpEntry &entry, double a, std::span<const Output> outputs) {
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> z;
    std::vector<double> conditions;
    for (const Output &output : outputs) {
        const catalog::Point p = toPoint(output);
        if (catalog::placement(entry, p) != catalog::Placement::Inside) {
            continue;
        }
        x.push_back(p.x);
        y.push_back(p.y);
        z.push_back(p.z);
        conditions.push_back(entry.conditioning(p, a));
    }
    StepResult worst;
    if (!conditions.empty()) {
        const auto middle = conditions.begin() + static_cast<long>(conditions.size() / 2);
        std::nth_element(conditions.begin(), middle, conditions.end());
        worst.rounding = kRoundings * catalog::kFloatRounding * *middle;
    }
    lookAt('x', std::move(x), worst);
    lookAt('y', std::move(y), worst);
    lookAt('z', std::move(z), worst);
    UnitSquarePoints square = toUnitSquare(entry, a, outputs);
    lookAt('u', std::move(square.u), worst);
    lookAt('v', std::move(square.v), worst);
    return worst;
}

} // namespace battery
