// SPDX-License-Identifier: MIT
#include "radiance_diagnosis.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace grader {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kModelError = 5e-3; ///< relative: a hypothesis is no closed form
constexpr double kLeastFit = 0.8;
constexpr double kConstantFit = 0.95;
constexpr double kFactorTolerance = 0.02;

/// A mean for a place and channel.
using Prediction = std::function<double(std::size_t place, std::size_t channel)>;

double meanOf(const RadianceMoments &image) {
    double sum = 0;
    double count = 0;
    for (const auto &channel : image) {
        for (const statistics::MomentSummary &place : channel) {
            sum += place.mean;
            ++count;
        }
    }
    return count > 0 ? sum / count : 0;
}

/// Whether every place has the same colour: to rounding, and not black.
bool isOneColour(const RadianceMoments &image) {
    constexpr double kRounding = 1e-5;
    bool black = true;
    for (const auto &channel : image) {
        for (const statistics::MomentSummary &place : channel) {
            if (std::abs(place.mean - channel.front().mean) > kRounding * channel.front().mean)
                return false;
            black = black && place.mean == 0;
        }
    }
    return !black;
}

/// Weighted squares of the deviation from a prediction, per place and channel.
double residual(const RadianceMoments &student, double scale, const Prediction &prediction) {
    double sum = 0;
    double count = 0;
    for (std::size_t c = 0; c < student.size(); ++c) {
        for (std::size_t i = 0; i < student[c].size(); ++i) {
            const statistics::MomentSummary &place = student[c][i];
            const double wanted = prediction(i, c);
            const double error = kModelError * (std::abs(wanted) + 0.05 * scale);
            const double variance =
                error * error + (place.count > 1 ? place.variance / place.count : 0);
            sum += (place.mean - wanted) * (place.mean - wanted) / std::max(variance, 1e-30);
            ++count;
        }
    }
    return count > 0 ? sum / count : 0;
}

struct NamedFactor {
    double value;
    const char *diagnosis;
};

std::vector<NamedFactor> namedFactors(int lightCount) {
    const double n = lightCount;
    std::vector<NamedFactor> factors;
    if (lightCount > 1)
        factors = {{1 / n, "ems.pick_pdf_forgotten"},
                   {1 / (n * n), "ems.pick_pdf_multiplied"},
                   {n, "ems.pick_pdf_twice"}};
    factors.insert(factors.end(), {{kPi, "ems.factor_pi"},
                                   {1 / kPi, "ems.factor_pi"},
                                   {4 * kPi, "ems.factor_four_pi"},
                                   {1 / (4 * kPi), "ems.factor_four_pi"},
                                   {2, "ems.factor_two"},
                                   {0.5, "ems.factor_two"}});
    return factors;
}

} // namespace

std::vector<Guess> guessRadiance(const RadianceMoments &student, const RadianceMoments &expected,
                                 const CaseDiagnoses &known) {
    const double scale = meanOf(expected);
    const double mean = meanOf(student);
    std::vector<Guess> guesses;
    if (std::abs(mean) <= 1e-9 * std::max(scale, 1e-9))
        guesses.push_back({known.black, 1});
    double noise = 0;
    for (const auto &channel : student) {
        for (const statistics::MomentSummary &place : channel)
            noise += place.variance;
    }
    if (known.isNoisy && mean > 0 && noise <= 1e-9 * mean * mean)
        guesses.push_back({"ems.samples_reused", 0.95});

    const auto right = [&](std::size_t i, std::size_t c) {
        return expected[c][i].mean;
    };
    const double error = residual(student, scale, right);
    // Of the deviation, not of its squares: against an image that is nearly black, black itself
    // would take away most of those.
    const auto fitOf = [&](const Prediction &prediction) {
        const double left = std::max(0.0, residual(student, scale, prediction) - 1);
        return error > 1 ? std::clamp(1 - std::sqrt(left / error), 0.0, 1.0) : 0.0;
    };
    for (const Hypothesis &hypothesis : known.hypotheses) {
        const double fit = fitOf([&](std::size_t i, std::size_t c) {
            return hypothesis.expected[i][static_cast<Eigen::Index>(c)];
        });
        if (fit >= kLeastFit)
            guesses.push_back({hypothesis.diagnosis, fit});
    }
    if (isOneColour(student) && !isOneColour(expected))
        guesses.push_back({"ems.constant_image", 1});
    const double factor = scale > 0 ? mean / scale : 1;
    const double common =
        fitOf([&](std::size_t i, std::size_t c) { return factor * expected[c][i].mean; });
    if (common >= kLeastFit && mean > 0) {
        for (const NamedFactor &named : namedFactors(known.lightCount)) {
            if (std::abs(factor / named.value - 1) <= kFactorTolerance)
                guesses.push_back({named.diagnosis, common});
        }
        guesses.push_back({"ems.factor", 0.5 * common});
    }
    const double offset = mean - scale;
    const double constant =
        fitOf([&](std::size_t i, std::size_t c) { return expected[c][i].mean + offset; });
    // Where places are alike, a constant is nearly a factor.
    if (constant >= kConstantFit && 1 - constant < 0.5 * (1 - common))
        guesses.push_back({"ems.constant_added", constant});
    guesses.push_back({known.other, known.otherFit});
    std::stable_sort(guesses.begin(), guesses.end(),
                     [](const Guess &a, const Guess &b) { return a.fit > b.fit; });
    return guesses;
}

} // namespace grader
