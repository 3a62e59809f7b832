// SPDX-License-Identifier: MIT
#pragma once

#include <battery/battery.h>
#include <battery/maps.h>

#include <span>

#include <plot/inline_plot.h>

namespace grader {

/// Residuals of a map, as a density, over the one that chance alone gives: N(0, 1).
plot::InlinePlot residualPlot(const battery::Maps &maps);

/// The 32x32 histogram's statistic on its density under "the rms error is within the tolerance",
/// with the rejected tail. \param level  of the whole test, of four histograms
plot::InlinePlot statisticPlot(const battery::DistributionResult &distribution, double level);

/// Sorted p-values against those of an even spread, with the band that holds each with 95 %.
plot::InlinePlot pValuePlot(std::span<const double> pValues);

/// Observed and expected counts along the row (axis 0) or column (1) of the worst cell.
plot::InlinePlot slicePlot(const battery::Maps &maps, std::size_t axis);

} // namespace grader
