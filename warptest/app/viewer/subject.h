// SPDX-License-Identifier: MIT
#pragma once

#include <battery/records.h>
#include <catalog/warp_entry.h>

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace viewer {

/// A warp to look at, beside the truth about it. The callables may throw: the window shows what().
/// They are called from one thread at a time.
struct Subject {
    const catalog::WarpEntry *truth = nullptr; ///< never null
    std::string name;                          ///< "triangle", for the list
    std::function<std::vector<battery::Output>(std::span<const battery::Input>, double a)> warp;
    std::function<std::vector<float>(std::span<const battery::Output>, double a)> density;
};

/// What a window shows first and the evidence is of: the stock tool's 0.1, where there is one.
double defaultParameter(const catalog::WarpEntry &truth);

} // namespace viewer
