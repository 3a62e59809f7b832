// SPDX-License-Identifier: MIT
#include "nearest_mistake.h"

#include <battery/inputs.h>
#include <battery/unit_square.h>

#include <algorithm>
#include <cmath>
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

} // namespace

MistakeMatch nearestMistake(const catalog::WarpEntry &entry, double a,
                            std::span<const Output> outputs) {
    if (outputs.empty()) {
        return {};
    }
    const std::vector<double> observed = frequencies(entry, a, outputs);
    std::vector<double> right(observed.size(), 1.0 / (kBins * kBins));
    right.back() = 0.0;
    const double error = distance(observed, right);
    // Sampling noise alone puts this much between a distribution and its own histogram.
    const double noise = 0.5 * kBins * kBins / static_cast<double>(outputs.size());

    const std::vector<Input> inputs = stratifiedInputs(kPredictionSide, 1);
    const catalog::WarpMistake *best = nullptr;
    double bestDistance = error;
    for (const catalog::WarpMistake &mistake : catalog::warpMistakes()) {
        if (mistake.warpId != entry.id) {
            continue;
        }
        const std::vector<Output> predicted = predictedOutputs(mistake, a, inputs);
        for (int k = 0; k < catalog::symmetryCount(entry); ++k) {
            const double d = distance(observed, frequencies(entry, a, moved(entry, predicted, k)));
            if (d < bestDistance) {
                bestDistance = d;
                best = &mistake;
            }
        }
    }
    MistakeMatch match;
    if (error > 0.0) {
        match.explained = std::min(1.0, 1.0 - std::max(0.0, bestDistance - noise) / error);
    }
    if (best != nullptr && error > 4.0 * noise && match.explained >= 0.95) {
        match.mistake = best;
    }
    return match;
}

} // namespace battery
