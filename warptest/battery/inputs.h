// SPDX-License-Identifier: MIT
#pragma once

#include <battery/records.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace battery {

/// {0, 2^-24, 2^-23, 2^-12, 1/4, 1/2 -+ ulp, 1/2, 3/4, 1 - 2^-12, 1 - 2^-23, 1 - 2^-24, 1}^2:
/// 169 inputs. A coordinate of exactly 1 is outside of the contract [0, 1): see isWithinContract().
std::vector<Input> edgeInputs();

/// Both coordinates are in [0, 1).
bool isWithinContract(const Input &input);

/// Cell centres of a `side` x `side` grid.
std::vector<Input> gridInputs(int side);

/// Independent uniform inputs, multiples of 2^-23 as Nori's samplers draw them.
std::vector<Input> randomInputs(std::size_t count, std::uint64_t seed);

/// One uniform input in each of `side` x `side` cells, rows of equal u-cell together.
std::vector<Input> stratifiedInputs(int side, std::uint64_t seed);

/// Two places of a batch that hold the same input.
struct DuplicatePair {
    std::size_t first = 0;
    std::size_t second = 0;
};

/// Inputs in random order with some hidden in it twice.
struct Batch {
    std::vector<Input> inputs;
    std::vector<DuplicatePair> pairs;
};

/// Adds copies of `pairs` randomly chosen inputs and shuffles everything. Statistics that need the
/// inputs once each take withoutDuplicates() of the outputs.
Batch hideDuplicates(std::vector<Input> inputs, std::size_t pairs, std::uint64_t seed);

/// Drops the second of each pair.
std::vector<Output> withoutDuplicates(const Batch &batch, std::span<const Output> outputs);

/// A warp is a function: equal inputs give equal bits. One that draws its own random numbers, or
/// keeps state, does not.
struct DuplicateResult {
    std::size_t pairs = 0;
    std::size_t differing = 0;
    std::size_t firstDiffering = 0; ///< index into Batch::pairs; meaningless if none differs
};

/// \throws std::invalid_argument  if the shapes differ.
DuplicateResult judgeDuplicates(const Batch &batch, std::span<const Output> outputs);

} // namespace battery
