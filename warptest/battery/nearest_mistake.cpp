// SPDX-License-Identifier: MIT
#include "nearest_mistake.h"

#include <battery/inputs.h>
#include <battery/unit_square.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace battery {

namespace {

constexpr int kBins = 32;
constexpr int kPredictionSide = 256;

/// Frequencies of the cells, and last that of outputs out of the domain; they sum to 1.
std::vector<double> frequencies(const catalog::WarpEntry &entry, double a,
                                std::span<const Output> outputs) {
    const UnitSquarePoints points = toUnitSquare(entry, a, outputs);
    std::vector<double> cells = countCells(points, kBins, kBins);
    cells.push_back(static_cast<double>(points.invalid()));
    for (double &cell : cells) {
        cell /= static_cast<double>(points.total);
    }
    return cells;
}

/// Symmetric chi^2 distance of two distributions, in [0, 2].
double distance(std::span<const double> p, std::span<const double> q) {
    double sum = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p[i] + q[i] > 0.0) {
            sum += (p[i] - q[i]) * (p[i] - q[i]) / (p[i] + q[i]);
        }
    }
    return sum;
}

std::vector<Output> predictedOutputs(const catalog::WarpMistake &mistake, double a,
                                     std::span<const Input> inputs) {
    std::vector<Output> outputs;
    outputs.reserve(inputs.size());
    for (const Input &input : inputs) {
        outputs.push_back(toOutput(
            mistake.warp({static_cast<double>(input.u), static_cast<double>(input.v)}, a)));
    }
    return outputs;
}

std::vector<Output> moved(const catalog::WarpEntry &entry, std::span<const Output> outputs,
                          int symmetry) {
    std::vector<Output> result;
    result.reserve(outputs.size());
    for (const Output &output : outputs) {
        result.push_back(toOutput(catalog::symmetry(entry, toPoint(output), symmetry)));
    }
    return result;
}

/// Of outputs, with the distance that the right distribution has from them.
struct Observed {
    std::vector<double> frequencies;
    double error = 0.0;
    double noise = 0.0; ///< the distance that sampling noise alone gives
};

Observed observe(const catalog::WarpEntry &entry, double a, std::span<const Output> outputs) {
    Observed observed;
    observed.frequencies = frequencies(entry, a, outputs);
    std::vector<double> right(observed.frequencies.size(), 1.0 / (kBins * kBins));
    right.back() = 0.0;
    observed.error = distance(observed.frequencies, right);
    observed.noise = 0.5 * kBins * kBins / static_cast<double>(outputs.size());
    return observed;
}

std::vector<MistakeMatch> rank(const catalog::WarpEntry &entry, double a,
                               const Observed &observed) {
    const std::vector<Input> inputs = stratifiedInputs(kPredictionSide, 1);
    std::vector<MistakeMatch> matches;
    for (const catalog::WarpMistake &mistake : catalog::warpMistakes()) {
        if (mistake.warpId != entry.id) {
            continue;
        }
        const std::vector<Output> predicted = predictedOutputs(mistake, a, inputs);
        double best = observed.error;
        for (int k = 0; k < catalog::symmetryCount(entry); ++k) {
            best = std::min(best, distance(observed.frequencies,
                                           frequencies(entry, a, moved(entry, predicted, k))));
        }
        const double unexplained =
            best < observed.error ? std::max(0.0, best - observed.noise) : observed.error;
        matches.push_back({&mistake, observed.error > 0.0
                                         ? std::min(1.0, 1.0 - unexplained / observed.error)
                                         : 0.0});
    }
    std::stable_sort(
        matches.begin(), matches.end(),
        [](const MistakeMatch &x, const MistakeMatch &y) { return x.explained > y.explained; });
    return matches;
}

} // namespace

std::vector<MistakeMatch> rankMistakes(const catalog::WarpEntry &entry, double a,
                                       std::span<const Output> outputs) {
    if (outputs.empty()) {
        throw std::invalid_argument("rankMistakes: there are no outputs");
    }
    return rank(entry, a, observe(entry, a, outputs));
}

MistakeMatch nearestMistake(const catalog::WarpEntry &entry, double a,
                            std::span<const Output> outputs) {
    if (outputs.empty()) {
        return {};
    }
    const Observed observed = observe(entry, a, outputs);
    const std::vector<MistakeMatch> matches = rank(entry, a, observed);
    if (matches.empty()) {
        return {};
    }
    MistakeMatch best = matches.front();
    if (observed.error <= 4.0 * observed.noise || best.explained < 0.95) {
        best.mistake = nullptr;
    }
    return best;
}

} // namespace battery
