// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace warp_exam {

/// Calls `work(i)` for i in [0, count) from all cores, in any order, and tells progress with the
/// time that is left on standard error.
void forEach(const std::string &what, std::size_t count,
             const std::function<void(std::size_t)> &work);

struct NullOptions {
    int runs = 30000;            ///< of each statistic, for each right warp
    std::size_t samples = 65536; ///< of each run
    int batteries = 500;         ///< whole-battery runs over all right configurations
    std::string warp;            ///< only warps whose name holds this; empty: all
    std::uint64_t seed = 1;
};

/// Right warps: how often each statistic falls below 1e-2, 1e-3 and 1e-4, and how whole batteries
/// end. \return  whether the counts agree with the levels and no battery fails
bool runNull(const NullOptions &options);

struct PowerOptions {
    int seeds = 5;
    std::string warp; ///< only configurations whose name holds this; empty: all
};

/// Wrong warps and densities: how often the battery fails them, beside the stock scheme.
/// \return  whether each is failed with every seed, or is right at its parameter
bool runPower(const PowerOptions &options);

} // namespace warp_exam
