// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

namespace statistics {

/// Two-sided p-value of a sum of independent values with symmetric laws about 0, whatever these
/// are: how often it would be as large if each value had the other sign at random. Between 2^10 and
/// 2^20 flips are drawn, until 32 sums were as large; no p-value is below 2^-20.
/// \param seed  of the flips
/// \see J. Besag, P. Clifford, "Sequential Monte Carlo p-values", Biometrika 78, 1991; W.
/// Hoeffding, "Probability inequalities for sums of bounded random variables", JASA 58, 1963,
/// Theorem 2.
double signFlipPValue(std::span<const double> values, std::uint64_t seed);

} // namespace statistics
