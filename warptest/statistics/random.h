// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

namespace statistics {

/// SplitMix64's output function: a bijection of 64-bit words in which every input bit reaches
/// every output bit.
/// \see G. Steele, D. Lea, C. Flood, "Fast splittable pseudorandom number generators", 2014.
std::uint64_t mix64(std::uint64_t word);

/// Seed of one batch of random numbers. Text goes in by 64-bit FNV-1a, and each part through
/// mix64(), so that seeds of neighbouring stages or replicates have nothing in common (never
/// `base + i`: samplers seeded alike reproduce each other's noise).
///
/// \param runSeed    The seed that a report prints: with it, a verdict can be reproduced.
/// \param purpose    Names the test and its part, such as "warp.triangle/independent".
/// \param stage      Stage of the triple lock, from 0.
/// \param replicate  Repetition within the stage, from 0.
std::uint64_t deriveSeed(std::uint64_t runSeed, std::string_view purpose, unsigned stage = 0,
                         unsigned replicate = 0);

/// SplitMix64 generator: the same numbers with every compiler and library. Draw each number in a
/// statement of its own: the order of evaluation of arguments is the compiler's choice.
class Random {
public:
    explicit Random(std::uint64_t seed) : m_state(seed) {}

    std::uint64_t nextBits();

    /// In [0, 1), a multiple of 2^-53.
    double nextDouble();

    /// In [0, 1), a multiple of 2^-23, as Nori's samplers draw it (0 occurs).
    float nextFloat();

    /// In {0, ..., bound - 1}; bound must be > 0. Bias below bound / 2^64.
    std::uint64_t nextBelow(std::uint64_t bound);

private:
    std::uint64_t m_state;
};

} // namespace statistics
