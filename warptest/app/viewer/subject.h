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
    std::string from = "renderer"; ///< whose code it is: of this project, or a hand-in's name
    bool isMistake = false;        ///< a known wrong one, for the tool's own tests
    std::function<std::vector<battery::Output>(std::span<const battery::Input>, double a)> warp;
    std::function<std::vector<float>(std::span<const battery::Output>, double a)> density;
};

/// Whether a command means this one: by its name, or by the id of a warp that is no known mistake.
bool isNamed(const Subject &subject, const std::string &name);

/// What a window shows first and the evidence is of: the stock tool's 0.1, where there is one.
double defaultParameter(const catalog::WarpEntry &truth);

} // namespace viewer
