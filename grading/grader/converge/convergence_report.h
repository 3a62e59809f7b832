// SPDX-License-Identifier: MIT
#pragma once

#include <grader/converge/convergence_study.h>

#include <string>

#include <plot/plot.h>

namespace grader {

/// `converges as 1/sqrt(n)`, `does not`, `cannot tell`, of the slope alone: it sees reused random
/// numbers, and is a poor detector of bias (5 % bend it to -0.46).
const char *convergenceVerdict(const statistics::ConvergenceFit &fit);

/// A table with a row per integrator and scene.
std::string convergenceTable(const std::vector<Convergence> &all);

/// The same with every point as JSON; its shape is convergence.schema.json beside this file.
std::string convergenceJson(const ConvergencePlan &plan, const std::vector<Convergence> &all);

/// Relative RMSE over samples per pixel.
plot::LogLogPlot convergencePlot(const std::vector<Convergence> &all);

} // namespace grader
