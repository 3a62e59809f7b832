// SPDX-License-Identifier: MIT
#include "sign_flips.h"

#include <statistics/random.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace statistics {

namespace {

constexpr int kEnough = 32; ///< sums as large: the p-value is then known to 18 %
constexpr int kFewestFlips = (1 << 10) - 1;
constexpr int kMostFlips = (1 << 20) - 1;
constexpr double kSmallest = 1.0 / (kMostFlips + 1);
constexpr std::size_t kGroup = 8; ///< values whose signs come from one byte

/// Sums of a group under all of its signs.
using Sums = std::array<double, 1u << kGroup>;

Sums sumsOf(std::span<const double> group) {
    Sums sums{};
    for (std::size_t signs = 0; signs < sums.size(); ++signs) {
        for (std::size_t i = 0; i < group.size(); ++i)
            sums[signs] += (signs >> i & 1u) != 0 ? -group[i] : group[i];
    }
    return sums;
}

} // namespace

double signFlipPValue(std::span<const double> values, std::uint64_t seed) {
    std::vector<Sums> groups;
    double sum = 0.0;
    double size = 0.0;
    for (std::size_t i = 0; i < values.size(); i += kGroup) {
        groups.push_back(sumsOf(values.subspan(i, std::min(kGroup, values.size() - i))));
        sum += groups.back()[0];
    }
    double squares = 0.0;
    for (const double value : values) {
        size += std::fabs(value);
        squares += value * value;
    }
    // Sums that are the same but for rounding are as large.
    const double least = std::fabs(sum) - 1e-12 * size;
    // Hoeffding's inequality bounds the p-value; where it is below the smallest one that flips can
    // give, they would tell no more.
    if (2.0 * std::exp(-least * least / (2.0 * squares)) < kSmallest)
        return kSmallest;
    Random random(seed);
    int large = 0;
    int flips = 1;
    for (; flips <= kMostFlips; ++flips) {
        double flipped = 0.0;
        std::uint64_t bits = 0;
        for (std::size_t group = 0; group < groups.size(); ++group) {
            if (group % sizeof(bits) == 0)
                bits = random.nextBits();
            flipped += groups[group][bits & 0xffu];
            bits >>= kGroup;
        }
        large += std::fabs(flipped) >= least ? 1 : 0;
        if (flips == kFewestFlips && large >= kEnough)
            break;
        if (flips > kFewestFlips && large == kEnough)
            return static_cast<double>(large) / flips;
    }
    flips = std::min(flips, kMostFlips);
    return static_cast<double>(large + 1) / (flips + 1);
}

} // namespace statistics
