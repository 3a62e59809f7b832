// SPDX-License-Identifier: MIT
#include "quadrature.h"

#include <boost/math/quadrature/gauss.hpp>

#include <cmath>
#include <stdexcept>
#include <string>

namespace statistics {

namespace {

struct LineNode {
    double position = 0.0; ///< in [0, 1]
    double weight = 0.0;
};

/// Boost keeps the non-negative half of the nodes on [-1, 1].
template <unsigned Order>
std::vector<LineNode> lineNodes() {
    using Rule = boost::math::quadrature::gauss<double, Order>;
    std::vector<LineNode> nodes;
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
        const double x = Rule::abscissa()[i];
        const double weight = 0.5 * Rule::weights()[i];
        nodes.push_back({0.5 * (1.0 + x), weight});
        nodes.push_back({0.5 * (1.0 - x), weight});
    }
    return nodes;
}

std::vector<LineNode> lineNodes(int order) {
    switch (order) {
    case 4:
        return lineNodes<4>();
    case 32:
        return lineNodes<32>();
    case 64:
        return lineNodes<64>();
    default:
        throw std::invalid_argument("gaussNodes: order " + std::to_string(order) +
                                    ", must be 4, 32 or 64");
    }
}

} // namespace

std::vector<QuadratureNode> gaussNodes(int order) {
    const std::vector<LineNode> line = lineNodes(order);
    std::vector<QuadratureNode> nodes;
    nodes.reserve(line.size() * line.size());
    for (const LineNode &a : line) {
        for (const LineNode &b : line) {
            nodes.push_back({a.position, b.position, a.weight * b.weight});
        }
    }
    return nodes;
}

std::vector<QuadratureNode> integrationNodes() {
    std::vector<QuadratureNode> nodes = gaussNodes(64);
    const std::vector<QuadratureNode> coarse = gaussNodes(32);
    nodes.insert(nodes.end(), coarse.begin(), coarse.end());
    return nodes;
}

QuadratureResult integrateNodes(std::span<const double> values) {
    const std::vector<QuadratureNode> nodes = integrationNodes();
    if (values.size() != nodes.size()) {
        throw std::invalid_argument("integrateNodes: " + std::to_string(values.size()) +
                                    " values for " + std::to_string(nodes.size()) + " nodes");
    }
    constexpr std::size_t kFine = std::size_t{64} * 64;
    double fine = 0.0;
    double coarse = 0.0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        (i < kFine ? fine : coarse) += nodes[i].weight * values[i];
    }
    return {fine, std::fabs(fine - coarse)};
}

QuadratureResult integrateUnitSquare(const std::function<double(double, double)> &integrand) {
    std::vector<double> values;
    for (const QuadratureNode &node : integrationNodes()) {
        values.push_back(integrand(node.u, node.v));
    }
    return integrateNodes(values);
}

} // namespace statistics
