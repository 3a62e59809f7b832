// SPDX-License-Identifier: MIT
#include "configurations.h"

#include <battery/unit_square.h>
#include <catalog/density_mistakes.h>
#include <catalog/warp_catalog.h>
#include <catalog/warp_mistakes.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <warptest/battery/sample_densities.h>
#include <warptest/battery/sample_warps.h>

namespace warp_exam {

namespace {

using battery::Input;
using battery::Output;
using sample_densities::SampleDensity;
using sample_warps::SampleWarp;

battery::Warp bind(const SampleWarp &sample, double a) {
    return [&sample, a](const Input &s) {
        return sample.warp(s, static_cast<float>(a));
    };
}

battery::Warp bind(const catalog::WarpMistake &mistake, double a) {
    return [&mistake, a](const Input &s) {
        return battery::toOutput(
            mistake.warp({static_cast<double>(s.u), static_cast<double>(s.v)}, a));
    };
}

battery::Density bind(const SampleDensity &sample, double a) {
    return [&sample, a](const Output &p) {
        return sample.density(p, static_cast<float>(a));
    };
}

battery::Density bind(const catalog::DensityMistake &mistake, double a) {
    return [&mistake, a](const Output &p) {
        return static_cast<float>(mistake.density(battery::toPoint(p), a));
    };
}

template <typename Samples>
const auto &firstOf(const Samples &samples, std::string_view warpId) {
    return *std::find_if(samples.begin(), samples.end(),
                         [=](const auto &sample) { return sample.warpId == warpId; });
}

template <typename List>
const auto &named(const List &list, std::string_view warpId, std::string_view id) {
    const auto found = std::find_if(list.begin(), list.end(), [=](const auto &item) {
        return item.warpId == warpId && item.id == id;
    });
    if (found == list.end()) {
        throw std::logic_error(fmt::format("{} {}: no such mistake", warpId, id));
    }
    return *found;
}

/// Wrong in both, so that the two may agree.
struct Pair {
    std::string_view warpId;
    std::string_view warp;
    std::string_view density;
};

constexpr auto kPairs = std::to_array<Pair>({
    {"sphere", "hemisphere", "upper_half_only"},
    {"hemisphere", "cosine_weighted", "cosine"},
    {"hemisphere", "whole_sphere", "sphere"},
    {"cosine_hemisphere", "uniform", "uniform"},
    {"cosine_hemisphere", "around_y", "around_y"},
    {"beckmann", "ggx", "ggx"},
    {"beckmann", "alpha_not_squared", "alpha_not_squared"},
    {"beckmann", "twice_alpha_squared", "twice_alpha_squared"},
});

struct Equivalence {
    std::string_view id;
    double a;
    std::string_view reason;
};

constexpr std::string_view kSquareOfOne = "alpha^2 = alpha at 1";
constexpr std::string_view kSmallAngle = "the lobe is so narrow that tan = angle";

constexpr auto kEquivalences = std::to_array<Equivalence>({
    {"alpha_not_squared", 1.0, kSquareOfOne},
    {"alpha_not_squared_in_front", 1.0, kSquareOfOne},
    {"alpha_not_squared_in_exponent", 1.0, kSquareOfOne},
    {"alpha_to_the_fourth", 1.0, kSquareOfOne},
    {"alpha_ignored_1", 1.0, "alpha is 1"},
    {"alpha_ignored_0_1", 0.1, "alpha is 0.1"},
    {"missing_arctangent", 0.01, kSmallAngle},
    {"missing_cosine", 0.01, "the lobe is so narrow that cos = 1"},
    {"alpha_tenth_percent_off", 0.01, "rounding of cos moves the points more"},
});

class Collector {
public:
    template <typename WarpSource, typename DensitySource>
    void add(std::string_view warpId, std::string_view id, const WarpSource &warp,
             const DensitySource &density, bool wrongWarp, bool wrongDensity) {
        const catalog::WarpEntry &target = catalog::requireWarp(warpId);
        for (const double a : target.parameters) {
            const char *what = wrongWarp && wrongDensity ? ", both" : wrongDensity ? ", pdf" : "";
            Configuration item{fmt::format("{} {}{}", warpId, id, what),
                               &target,
                               a,
                               bind(warp, a),
                               bind(density, a),
                               wrongWarp,
                               wrongDensity};
            for (const Equivalence &known : kEquivalences) {
                if (warpId == "beckmann" && known.id == id && known.a == a) {
                    item.equivalence = known.reason;
                }
            }
            m_items.push_back(std::move(item));
        }
    }

    std::vector<Configuration> take() { return std::move(m_items); }

private:
    std::vector<Configuration> m_items;
};

void addWrongWarps(Collector &collector) {
    const auto addSample = [&](const SampleWarp &sample) {
        collector.add(sample.warpId, sample.name, sample,
                      firstOf(sample_densities::kRight, sample.warpId), true, false);
    };
    std::for_each(sample_warps::kWrong.begin(), sample_warps::kWrong.end(), addSample);
    std::for_each(sample_warps::kNotFinite.begin(), sample_warps::kNotFinite.end(), addSample);
    for (const catalog::WarpMistake &mistake : catalog::warpMistakes()) {
        const bool hasSample = std::any_of(
            sample_warps::kWrong.begin(), sample_warps::kWrong.end(), [&](const auto &sample) {
                return sample.warpId == mistake.warpId && sample.mistakeId == mistake.id;
            });
        if (!hasSample) {
            collector.add(mistake.warpId, mistake.id, mistake,
                          firstOf(sample_densities::kRight, mistake.warpId), true, false);
        }
    }
}

void addWrongDensities(Collector &collector) {
    const auto addSample = [&](const SampleDensity &sample) {
        collector.add(sample.warpId, sample.name, firstOf(sample_warps::kRight, sample.warpId),
                      sample, false, true);
    };
    std::for_each(sample_densities::kWrong.begin(), sample_densities::kWrong.end(), addSample);
    std::for_each(sample_densities::kWrongAtRounding.begin(),
                  sample_densities::kWrongAtRounding.end(), addSample);
    for (const catalog::DensityMistake &mistake : catalog::densityMistakes()) {
        const bool hasSample = std::any_of(sample_densities::kWrong.begin(),
                                           sample_densities::kWrong.end(), [&](const auto &sample) {
                                               return sample.warpId == mistake.warpId &&
                                                      sample.mistakeId == mistake.id;
                                           });
        if (!hasSample) {
            collector.add(mistake.warpId, mistake.id, firstOf(sample_warps::kRight, mistake.warpId),
                          mistake, false, true);
        }
    }
}

/// Distance on a circle of circumference 1.
double around(double a, double b) {
    const double d = std::fabs(a - b);
    return std::min(d, 1.0 - d);
}

double warpDistance(const Configuration &item) {
    constexpr int kSide = 512;
    const std::vector<Input> inputs = battery::gridInputs(kSide);
    const std::vector<Output> outputs = item.warp(inputs);
    double largest = 0.0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const catalog::Square s = item.target->rosenblatt(battery::toPoint(outputs[i]), item.a);
        largest = std::max({largest, std::fabs(s.u - static_cast<double>(inputs[i].u)),
                            around(s.v, static_cast<double>(inputs[i].v))});
    }
    return largest;
}

} // namespace

std::vector<Configuration> rightConfigurations() {
    Collector collector;
    for (const SampleWarp &sample : sample_warps::kRight) {
        collector.add(sample.warpId, sample.name, sample,
                      firstOf(sample_densities::kRight, sample.warpId), false, false);
    }
    return collector.take();
}

std::vector<Configuration> wrongConfigurations() {
    Collector collector;
    addWrongWarps(collector);
    addWrongDensities(collector);
    for (const Pair &pair : kPairs) {
        collector.add(pair.warpId, pair.warp,
                      named(catalog::warpMistakes(), pair.warpId, pair.warp),
                      named(catalog::densityMistakes(), pair.warpId, pair.density), true, true);
    }
    return collector.take();
}

Distance distanceFromRight(const Configuration &item) {
    constexpr std::size_t kPoints = 20000;
    Distance distance;
    const double rounding =
        catalog::kFloatRounding * catalog::edgeConditioning(*item.target, item.a);
    distance.warpTolerance = std::max(5e-4, rounding);
    if (item.wrongWarp) {
        distance.warp = warpDistance(item);
    }
    if (item.wrongDensity) {
        std::vector<Output> points;
        std::vector<double> tolerances;
        for (const Input &s : battery::randomInputs(kPoints, 1)) {
            points.push_back(battery::toOutput(
                item.target->warp({static_cast<double>(s.u), static_cast<double>(s.v)}, item.a)));
            tolerances.push_back(
                1e-4 + 4.0 * catalog::kFloatRounding *
                           item.target->conditioning(battery::toPoint(points.back()), item.a));
        }
        const std::vector<float> pdfs = item.density(points);
        std::vector<double> errors;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double exact = item.target->density(battery::toPoint(points[i]), item.a);
            errors.push_back(std::fabs(static_cast<double>(pdfs[i]) / exact - 1.0));
        }
        const auto at = static_cast<long>(0.999 * kPoints);
        std::nth_element(errors.begin(), errors.begin() + at, errors.end());
        distance.density = errors[static_cast<std::size_t>(at)];
        distance.densityTolerance = *std::min_element(tolerances.begin(), tolerances.end());
    }
    return distance;
}

} // namespace warp_exam
