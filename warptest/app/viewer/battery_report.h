// SPDX-License-Identifier: MIT
#pragma once

#include <viewer/report.h>

namespace viewer {

/// Runs the battery on a warp and its density: range, density point by point, normalisation,
/// stratified moments, distribution (triple lock), consistency, nearest known mistake. Without
/// maps. What the warp or density throws becomes the report's `error`.
TestReport runBattery(const Subject &subject, const Settings &settings, const TestControl &control);

} // namespace viewer
