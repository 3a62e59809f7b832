// SPDX-License-Identifier: MIT
#include "inputs.h"

#include <statistics/random.h>

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <stdexcept>

namespace battery {

namespace {

bool sameBits(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

bool sameBits(const Output &a, const Output &b) {
    return sameBits(a.x, b.x) && sameBits(a.y, b.y) && sameBits(a.z, b.z);
}

/// `(cell + offset) / side` in single precision, kept in [0, 1).
float inCell(int cell, double offset, int side) {
    return std::min(static_cast<float>((cell + offset) / side), 1.0F - 0x1p-24F);
}

} // namespace

std::vector<Input> edgeInputs() {
    constexpr std::array<float, 13> kValues{
        0.0F, 0x1p-24F,        0x1p-23F, 0x1p-12F,        0.25F,           0.5F - 0x1p-25F,
        0.5F, 0.5F + 0x1p-24F, 0.75F,    1.0F - 0x1p-12F, 1.0F - 0x1p-23F, 1.0F - 0x1p-24F,
        1.0F};
    std::vector<Input> inputs;
    for (const float u : kValues) {
        for (const float v : kValues) {
            inputs.push_back({u, v});
        }
    }
    return inputs;
}

bool isWithinContract(const Input &input) {
    return input.u >= 0.0F && input.u < 1.0F && input.v >= 0.0F && input.v < 1.0F;
}

std::vector<Input> gridInputs(int side) {
    std::vector<Input> inputs;
    for (int i = 0; i < side; ++i) {
        for (int j = 0; j < side; ++j) {
            inputs.push_back({inCell(i, 0.5, side), inCell(j, 0.5, side)});
        }
    }
    return inputs;
}

std::vector<Input> randomInputs(std::size_t count, std::uint64_t seed) {
    statistics::Random random(seed);
    std::vector<Input> inputs(count);
    for (Input &input : inputs) {
        input.u = random.nextFloat();
        input.v = random.nextFloat();
    }
    return inputs;
}

std::vector<Input> stratifiedInputs(int side, std::uint64_t seed) {
    statistics::Random random(seed);
    std::vector<Input> inputs;
    for (int i = 0; i < side; ++i) {
        for (int j = 0; j < side; ++j) {
            Input input;
            input.u = inCell(i, random.nextDouble(), side);
            input.v = inCell(j, random.nextDouble(), side);
            inputs.push_back(input);
        }
    }
    return inputs;
}

Batch hideDuplicates(std::vector<Input> inputs, std::size_t pairs, std::uint64_t seed) {
    statistics::Random random(seed);
    const std::size_t originals = inputs.size();
    if (originals == 0) {
        return {};
    }
    std::vector<std::size_t> sources;
    for (std::size_t i = 0; i < pairs; ++i) {
        sources.push_back(random.nextBelow(originals));
        inputs.push_back(inputs[sources.back()]);
    }
    std::vector<std::size_t> order(inputs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = order.size() - 1; i > 0; --i) { // std::shuffle depends on the library
        std::swap(order[i], order[random.nextBelow(i + 1)]);
    }
    std::vector<std::size_t> place(inputs.size());
    Batch batch;
    batch.inputs.resize(inputs.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        batch.inputs[i] = inputs[order[i]];
        place[order[i]] = i;
    }
    for (std::size_t i = 0; i < pairs; ++i) {
        batch.pairs.push_back({place[sources[i]], place[originals + i]});
    }
    return batch;
}

std::vector<Output> withoutDuplicates(const Batch &batch, std::span<const Output> outputs) {
    if (outputs.size() != batch.inputs.size()) {
        throw std::invalid_argument("withoutDuplicates: one output per input is needed");
    }
    std::vector<bool> dropped(outputs.size(), false);
    for (const DuplicatePair &pair : batch.pairs) {
        dropped[pair.second] = true;
    }
    std::vector<Output> kept;
    kept.reserve(outputs.size() - batch.pairs.size());
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        if (!dropped[i]) {
            kept.push_back(outputs[i]);
        }
    }
    return kept;
}

DuplicateResult judgeDuplicates(const Batch &batch, std::span<const Output> outputs) {
    if (outputs.size() != batch.inputs.size()) {
        throw std::invalid_argument("judgeDuplicates: one output per input is needed");
    }
    DuplicateResult result;
    result.pairs = batch.pairs.size();
    for (std::size_t i = 0; i < batch.pairs.size(); ++i) {
        if (!sameBits(outputs[batch.pairs[i].first], outputs[batch.pairs[i].second])) {
            if (result.differing++ == 0) {
                result.firstDiffering = i;
            }
        }
    }
    return result;
}

} // namespace battery
