// SPDX-License-Identifier: MIT
#include "consistency.h"

#include <battery/unit_square.h>
#include <statistics/chi_square.h>

#include <cmath>
#include <numeric>
#include <stdexcept>

namespace battery {

namespace {

constexpr int kCells = 32;
constexpr int kOrder = 4;

Output exactOutput(const catalog::WarpEntry &entry, double a, double u, double v) {
    return toOutput(entry.warp({u, v}, a));
}

/// Density over exact density at a point; 0 where either is no proper density.
double ratio(const catalog::WarpEntry &entry, double a, const Output &point, float pdf) {
    const double exact = entry.formula(toPoint(point), a);
    const double value = static_cast<double>(pdf) / exact;
    return std::isfinite(value) && value > 0.0 ? value : 0.0;
}

} // namespace

std::vector<Output> normalisationPoints(const catalog::WarpEntry &entry, double a) {
    std::vector<Output> points;
    for (const statistics::QuadratureNode &node : statistics::integrationNodes()) {
        points.push_back(exactOutput(entry, a, node.u, node.v));
    }
    return points;
}

statistics::QuadratureResult judgeNormalisation(const catalog::WarpEntry &entry, double a,
                                                std::span<const float> pdfs) {
    const std::vector<Output> points = normalisationPoints(entry, a);
    if (pdfs.size() != points.size()) {
        throw std::invalid_argument("judgeNormalisation: one density per point is needed");
    }
    std::vector<double> ratios;
    ratios.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        ratios.push_back(ratio(entry, a, points[i], pdfs[i]));
    }
    return statistics::integrateNodes(ratios);
}

std::vector<Output> consistencyPoints(const catalog::WarpEntry &entry, double a) {
    const std::vector<statistics::QuadratureNode> nodes = statistics::gaussNodes(kOrder);
    std::vector<Output> points;
    for (int i = 0; i < kCells; ++i) {
        for (int j = 0; j < kCells; ++j) {
            for (const statistics::QuadratureNode &node : nodes) {
                points.push_back(
                    exactOutput(entry, a, (i + node.u) / kCells, (j + node.v) / kCells));
            }
        }
    }
    return points;
}

ConsistencyResult judgeConsistency(const catalog::WarpEntry &entry, double a,
                                   std::span<const Output> outputs, std::span<const float> pdfs) {
    const std::vector<statistics::QuadratureNode> nodes = statistics::gaussNodes(kOrder);
    const std::vector<Output> places = consistencyPoints(entry, a);
    if (pdfs.size() != places.size() || outputs.empty()) {
        throw std::invalid_argument(
            "judgeConsistency: one density per point and at least one output are needed");
    }
    const auto total = static_cast<double>(outputs.size());
    std::vector<double> expected(static_cast<std::size_t>(kCells) * kCells);
    ConsistencyResult result;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double share = nodes[i % nodes.size()].weight * ratio(entry, a, places[i], pdfs[i]) /
                             (kCells * kCells);
        expected[i / nodes.size()] += total * share;
        result.insideMass += share;
    }
    const UnitSquarePoints points = toUnitSquare(entry, a, outputs);
    const std::vector<double> observed = countCells(points, kCells, kCells);
    result.insideSamples = static_cast<double>(points.u.size()) / total;

    const statistics::ChiSquareResult test = statistics::chiSquareTest(observed, expected);
    result.statistic = test.statistic;
    result.degreesOfFreedom = test.degreesOfFreedom;
    if (test.degreesOfFreedom == 0 || test.impossibleHits > 0.0) {
        result.pValue = 0.0;
        result.rmsError = 1.0;
        return result;
    }
    // The counts are not bound to sum to N where the density reaches beyond the support, or is not
    // normalised: then one more degree of freedom is what is tested.
    result.degreesOfFreedom += 1;
    result.rmsError = statistics::rmsErrorEstimate(test.statistic, result.degreesOfFreedom, total);
    result.pValue =
        statistics::toleranceZonePValue(test.statistic, result.degreesOfFreedom, total,
                                        catalog::distributionTolerance(entry, a, kCells));
    return result;
}

} // namespace battery
