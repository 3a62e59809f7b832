// SPDX-License-Identifier: MIT
#include "binomial.h"

#include <boost/math/distributions/binomial.hpp>

#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace statistics {

Interval clopperPearson(std::uint64_t successes, std::uint64_t trials, double level) {
    if (trials == 0 || successes > trials) {
        throw std::invalid_argument("clopperPearson: " + std::to_string(successes) +
                                    " successes in " + std::to_string(trials) + " trials");
    }
    using Law = boost::math::binomial_distribution<double>;
    const auto n = static_cast<double>(trials);
    const auto k = static_cast<double>(successes);
    return {successes == 0 ? 0.0 : Law::find_lower_bound_on_p(n, k, level / 2.0),
            successes == trials ? 1.0 : Law::find_upper_bound_on_p(n, k, level / 2.0)};
}

ChiSquareResult multinomialTest(std::span<const double> counts,
                                std::span<const double> probabilities, double minExpected) {
    const double total = std::accumulate(probabilities.begin(), probabilities.end(), 0.0);
    if (!(std::fabs(total - 1.0) <= 1e-9)) {
        throw std::invalid_argument("multinomialTest: the probabilities sum to " +
                                    std::to_string(total) + ", not 1");
    }
    const double sampleCount = std::accumulate(counts.begin(), counts.end(), 0.0);
    std::vector<double> expected(probabilities.begin(), probabilities.end());
    for (double &entry : expected) {
        entry *= sampleCount;
    }
    return chiSquareTest(counts, expected, {.minExpected = minExpected});
}

} // namespace statistics
