// SPDX-License-Identifier: MIT
#pragma once

#include <statistics/chi_square.h>

#include <cstdint>
#include <span>

namespace statistics {

struct Interval {
    double lower = 0.0;
    double upper = 1.0;
};

/// Exact two-sided confidence interval of a proportion.
/// \param level  Probability to miss the true proportion (0.05 gives a 95 % interval).
/// \throws std::invalid_argument  if there are no trials or more successes than trials.
/// \see C. Clopper and E. Pearson, Biometrika 26, 1934.
Interval clopperPearson(std::uint64_t successes, std::uint64_t trials, double level = 0.05);

/// Chi^2 test of counts against pick probabilities.
///
/// \param counts         Picks per entry, shape [entries].
/// \param probabilities  Shape [entries]; sum 1 within 1e-9. A hit on an entry of probability 0
///                       makes the p-value 0.
/// \param minExpected    Entries are pooled in order to this expectation; 20, since pick
///                       probabilities may be very unequal.
/// \throws std::invalid_argument  if the shapes differ or the probabilities do not sum to 1.
ChiSquareResult multinomialTest(std::span<const double> counts,
                                std::span<const double> probabilities, double minExpected = 20.0);

} // namespace statistics
