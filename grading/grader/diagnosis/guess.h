// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace grader {

/// A mistake that would explain what was measured.
struct Guess {
    std::string id; ///< of the catalogue
    double fit = 1; ///< part of the deviation that it explains [0, 1]
};

/// Most that are told of one check or item.
constexpr std::size_t kMostGuesses = 3;

/// Fit of a guess that follows from what failed, and not from how: it stands back behind any other.
constexpr double kVagueFit = 0.3;

/// The best ones, each once: fits are compared in tenths, and of equal ones the first comes first,
/// so that what is tested first is told first.
std::vector<Guess> bestGuesses(const std::vector<Guess> &guesses);

} // namespace grader
