// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

namespace catalog {

/// A density divided by the true one at a point, with what the ratio may depend on.
struct RatioSample {
    double ratio = 1.0;    ///< positive and finite
    double cosTheta = 1.0; ///< z of the direction; 1 in the plane
};

/// The law that explains a density's error inside the support: ratio = constant * cos^power.
struct RatioLaw {
    bool found = false; ///< no such law explains the samples
    double constant = 1.0;
    int cosinePower = 0;      ///< 1: a cosine too many; -1: one is missing
    std::string constantName; ///< "pi", "1/2", "alpha^2"; empty if it is no known number
};

/// Finds the law, to a relative accuracy of `tolerance` for 99 % of the samples.
/// \param a  The warp's parameter, to recognise its powers; 0 if it has none.
RatioLaw explainRatio(std::span<const RatioSample> samples, double a, double tolerance = 2e-3);

/// The name of a constant factor, or "" if it is no known one ("1" is the right density).
/// \param tolerance  Relative.
std::string constantName(double constant, double a, double tolerance = 2e-4);

} // namespace catalog
