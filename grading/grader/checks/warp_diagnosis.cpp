// SPDX-License-Identifier: MIT
#include "warp_diagnosis.h"

#include <battery/steps.h>
#include <grader/diagnosis/catalogue.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace grader {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kLeastFit = 0.5; ///< of a known mistake, to be told

/// Fewer are no histogram.
constexpr std::size_t kFewOutputs = 4096;

/// Mistakes that one diagnosis covers.
struct Alias {
    std::string_view warp;
    std::string_view mistake;
    const char *diagnosis;
};

constexpr Alias kAliases[] = {
    {"triangle", "three_uniforms", "triangle.divided_by_sum"},
    {"triangle", "three_weights", "triangle.divided_by_sum"},
    {"triangle", "pdf_everywhere", "warp.pdf_outside"},
    {"triangle", "pdf_one_everywhere", "warp.pdf_one"},
    {"triangle", "pdf_unit_square", "warp.pdf_one"},
    {"disk", "pdf_everywhere", "warp.pdf_outside"},
    {"disk", "pdf_one_everywhere", "warp.pdf_one"},
    {"sphere", "not_scaled", "warp.not_unit"},
    {"sphere", "pdf_upper_half_only", "sphere.pdf_hemisphere"},
    {"hemisphere", "lifted_uniform_disk_radius", "hemisphere.lifted_disk"},
    {"cosine_hemisphere", "both_sides", "warp.whole_sphere"},
    {"cosine_hemisphere", "not_lifted", "warp.not_unit"},
    {"cosine_hemisphere", "pdf_absolute_cosine", "warp.pdf_below_horizon"},
    {"cosine_hemisphere", "pdf_negative_below", "warp.pdf_negative"},
    {"beckmann", "alpha_not_squared", "beckmann.alpha_power"},
    {"beckmann", "twice_alpha_squared", "beckmann.alpha_power"},
    {"beckmann", "half_alpha_squared", "beckmann.alpha_power"},
    {"beckmann", "alpha_to_the_fourth", "beckmann.alpha_power"},
    {"beckmann", "alpha_ignored_1", "beckmann.alpha_ignored"},
    {"beckmann", "alpha_ignored_0_1", "beckmann.alpha_ignored"},
    {"beckmann", "decimal_logarithm", "beckmann.formula"},
    {"beckmann", "missing_root", "beckmann.formula"},
    {"beckmann", "missing_arctangent", "beckmann.formula"},
    {"beckmann", "pdf_alpha_not_squared", "beckmann.pdf_alpha_power"},
    {"beckmann", "pdf_alpha_not_squared_in_exponent", "beckmann.pdf_alpha_power"},
    {"beckmann", "pdf_twice_alpha_squared", "beckmann.pdf_alpha_power"},
    {"beckmann", "pdf_negative_below", "warp.pdf_negative"},
};

/// A ratio to the true density that has a meaning for one warp; see catalog::RatioLaw.
struct KnownRatio {
    std::string_view warp; ///< empty: any
    double constant;
    int cosinePower;
    const char *diagnosis;
};

constexpr KnownRatio kRatios[] = {
    {"triangle", 0.5, 0, "warp.pdf_one"},
    {"triangle", 0.25, 0, "warp.pdf_is_area"},
    {"disk", kPi, 0, "warp.pdf_one"},
    {"disk", kPi *kPi, 0, "warp.pdf_is_area"},
    {"sphere", 4 * kPi, 0, "warp.pdf_one"},
    {"sphere", 16 * kPi *kPi, 0, "warp.pdf_is_area"},
    {"sphere", 2, 0, "sphere.pdf_hemisphere"},
    {"hemisphere", 2 * kPi, 0, "warp.pdf_one"},
    {"hemisphere", 4 * kPi *kPi, 0, "warp.pdf_is_area"},
    {"hemisphere", 0.5, 0, "warp.pdf_sphere"},
    {"hemisphere", 2, 1, "hemisphere.pdf_cosine"},
    {"cosine_hemisphere", 0.5, -1, "cosine_hemisphere.pdf_uniform"},
    {"cosine_hemisphere", 1, -1, "cosine_hemisphere.pdf_uniform"},
    {"cosine_hemisphere", 0.25, -1, "warp.pdf_sphere"},
    {"beckmann", 1, -1, "beckmann.pdf_missing_cosine"},
    {"", 1, -1, "warp.pdf_missing_cosine"},
    {"", 1, 1, "warp.pdf_extra_cosine"},
    {"", -1, 0, "warp.pdf_negative"},
};

bool isNear(double value, double target) {
    return std::abs(value - target) <= 2e-4 * std::abs(target);
}

/// From the name of a constant factor: what it is made of.
Guess guessConstant(const std::string &name) {
    const auto holds = [&](const char *part) {
        return name.find(part) != std::string::npos;
    };
    if (name.empty())
        return {"warp.pdf_factor", 0.6};
    if (holds("alpha"))
        return {"beckmann.pdf_alpha_power", 1};
    if (holds("pi/3"))
        return {"warp.pdf_rough_pi", 1};
    return {holds("pi") ? "warp.pdf_factor_pi" : "warp.pdf_factor_two", 1};
}

/// True if the density is 0 near the boundary only: of points anywhere, 43 % or more lie deeper.
bool isCut(const battery::DensityResult &density) {
    constexpr double kMargin = 0.1;
    constexpr std::size_t kMany = 50;
    return density.zeroDepth < kMargin && density.zeroAtTarget >= kMany;
}

Guess guessRatio(const catalog::WarpEntry &warp, const catalog::RatioLaw &law) {
    for (const KnownRatio &known : kRatios) {
        if ((known.warp.empty() || known.warp == warp.id) && known.cosinePower == law.cosinePower &&
            isNear(law.constant, known.constant))
            return {known.diagnosis, 1};
    }
    if (law.cosinePower != 0)
        return {"warp.pdf_cosine_power", 0.9};
    return guessConstant(law.constantName);
}

} // namespace

std::string warpDiagnosis(std::string_view warp, std::string_view mistake) {
    for (const Alias &alias : kAliases) {
        if (alias.warp == warp && alias.mistake == mistake)
            return alias.diagnosis;
    }
    for (const std::string_view owner : {warp, std::string_view("warp")}) {
        std::string id(owner);
        id += '.';
        id += mistake;
        if (findDiagnosis(id) != nullptr)
            return id;
    }
    return {};
}

std::vector<Guess> guessSamples(const catalog::WarpEntry &warp, double parameter,
                                const std::vector<battery::Output> &outputs) {
    std::vector<Guess> guesses;
    if (outputs.size() < kFewOutputs)
        return guesses;
    for (const battery::MistakeMatch &match : battery::rankMistakes(warp, parameter, outputs)) {
        if (match.explained >= kLeastFit)
            guesses.push_back({warpDiagnosis(warp.id, match.mistake->id), match.explained});
    }
    if (battery::judgeSteps(warp, parameter, outputs).isLined())
        guesses.push_back({"warp.rounded", 0.95});
    guesses.push_back({"warp.density_of_points", kVagueFit});
    return guesses;
}

std::vector<Guess> guessRange(const catalog::WarpEntry &warp, double parameter,
                              const battery::RangeResult &range,
                              const std::vector<battery::Output> &outputs) {
    if (range.notFinite > range.bad() / 2)
        return {{"warp.not_finite", 1}};
    std::vector<Guess> guesses = guessSamples(warp, parameter, outputs);
    if (!guesses.empty())
        guesses.pop_back(); // that points are wrong is said better by what follows
    if (range.offNorm <= range.bad() / 2) {
        guesses.push_back({"warp.out_of_domain", kVagueFit});
        return guesses;
    }
    // Certain, whatever mistake the directions alone look like.
    for (Guess &guess : guesses)
        guess.fit *= 0.9;
    guesses.push_back({"warp.not_unit", 1});
    return guesses;
}

std::vector<Guess> guessDensity(const catalog::WarpEntry &warp,
                                const battery::DensityResult &density, bool outside) {
    std::vector<Guess> guesses;
    if (density.mistake != nullptr)
        guesses.push_back({warpDiagnosis(warp.id, "pdf_" + std::string(density.mistake->id)), 1});
    if (outside) {
        if (!std::isfinite(density.outsideSize))
            guesses.push_back({"warp.pdf_not_finite", 0.9});
        if (density.outsideMass < 0)
            guesses.push_back({"warp.pdf_negative", 0.9});
        guesses.push_back(
            {warp.dimension == 3 ? "warp.pdf_below_horizon" : "warp.pdf_outside", 0.8});
        return guesses;
    }
    if (density.notFinite > 0)
        guesses.push_back({"warp.pdf_not_finite", 0.9});
    if (density.ratio.found &&
        !(density.ratio.cosinePower == 0 && density.ratio.constantName == "1"))
        guesses.push_back(guessRatio(warp, density.ratio));
    if (density.zeroAtTarget > 0 && isNear(density.medianRatio, 1))
        guesses.push_back({isCut(density) ? "warp.pdf_cut" : "warp.pdf_exact_norm",
                           static_cast<double>(density.zeroAtTarget) /
                               static_cast<double>(density.wrongAtTarget)});
    if (density.negative > 0)
        guesses.push_back({"warp.pdf_negative", 0.7});
    guesses.push_back({"warp.pdf_wrong", kVagueFit});
    return guesses;
}

} // namespace grader
