// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace statistics {

/// A point of the unit square and its share of the integral.
struct QuadratureNode {
    double u = 0.0;
    double v = 0.0;
    double weight = 0.0;
};

struct QuadratureResult {
    double value = 0.0;
    double errorBound = 0.0; ///< difference between the two orders
};

/// Gauss-Legendre nodes on the unit square, `order`^2 of them, u slowest; weights sum to 1.
/// \throws std::invalid_argument  unless order is 4, 32 or 64.
std::vector<QuadratureNode> gaussNodes(int order);

/// The two rules of integrateUnitSquare() as one list (the 64x64 nodes, then the 32x32), for
/// integrands that are evaluated elsewhere.
std::vector<QuadratureNode> integrationNodes();

/// Integral from values at integrationNodes(), shape [5120], same order.
/// \throws std::invalid_argument  if the shape differs.
QuadratureResult integrateNodes(std::span<const double> values);

/// Integral over the unit square by 64x64 Gauss-Legendre points; the difference to 32x32 bounds
/// the error of smooth integrands. It does not of a narrow peak: integrate a ratio that is 1 for
/// right code, never a raw density.
QuadratureResult integrateUnitSquare(const std::function<double(double, double)> &integrand);

} // namespace statistics
