// SPDX-License-Identifier: MIT
#pragma once

#include <battery/records.h>

#include <cstddef>
#include <span>
#include <string_view>

namespace battery {

/// Outputs that are not in the warp's domain, of inputs within the contract [0, 1).
struct RangeResult {
    std::size_t total = 0;      ///< inputs within the contract
    std::size_t notFinite = 0;  ///< NaN or infinity
    std::size_t offNorm = 0;    ///< directions whose norm is not 1 within 1e-5
    std::size_t outside = 0;    ///< outside of the support by more than 1e-6
    double worstDistance = 0.0; ///< largest error of the norm or distance from the support
    /// Index of the first output of each kind that is bad; `total` inputs may be fewer than given.
    std::size_t firstBad = 0;          ///< meaningless if nothing is bad
    std::size_t badBeyondContract = 0; ///< among inputs with a coordinate of exactly 1: a remark

    [[nodiscard]] std::size_t bad() const { return notFinite + offNorm + outside; }

    /// Of the inputs within the contract. At the edge inputs this is no probability: a failure
    /// there alone (a corner of measure zero) is worth a remark, never an accusation.
    [[nodiscard]] double badFraction() const {
        return total > 0 ? static_cast<double>(bad()) / static_cast<double>(total) : 0.0;
    }
};

/// A fraction of bad outputs up to this is a blemish: what Nori's films drop without a trace.
inline constexpr double kTolerableBadFraction = 1e-5;

/// Looks at every output: use with edgeInputs(), gridInputs() and randomInputs().
/// \throws std::invalid_argument  if the shapes differ.
RangeResult judgeRange(const catalog::WarpEntry &entry, std::span<const Input> inputs,
                       std::span<const Output> outputs);

} // namespace battery
