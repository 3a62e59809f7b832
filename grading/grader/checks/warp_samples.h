// SPDX-License-Identifier: MIT
#pragma once

#include <battery/records.h>
#include <catalog/warp_catalog.h>
#include <grader/prober/prober.h>
#include <grader/results/results.h>

#include <optional>
#include <span>
#include <vector>

namespace grader {

struct WarpAnswer {
    std::vector<std::vector<battery::Output>> outputs; ///< one list per list of inputs
    std::optional<CheckResult> failure;                ///< set when there is nothing to judge
};

/// Maps lists of inputs by the student's warp, in one process.
WarpAnswer askWarp(ProbeClient &probe, const catalog::WarpEntry &warp, double parameter,
                   const std::vector<std::vector<battery::Input>> &inputs);

struct DensityAnswer {
    std::vector<std::vector<float>> densities; ///< one list per list of points
    std::optional<CheckResult> failure;
};

/// Asks the student's density at lists of points, in one process.
DensityAnswer askDensity(ProbeClient &probe, const catalog::WarpEntry &warp, double parameter,
                         const std::vector<std::vector<battery::Output>> &points);

} // namespace grader
