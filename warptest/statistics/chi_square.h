// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

namespace statistics {

struct ChiSquareConfig {
    /// Neighbouring cells are pooled, in the order given, until each group expects this many.
    /// 5 is enough for cells of about equal expectation; take 20 when they are very unequal.
    double minExpected = 5.0;
};

struct ChiSquareResult {
    double statistic = 0.0;
    int degreesOfFreedom = 0;    ///< groups after pooling, minus 1
    double pValue = 1.0;         ///< of the plain (central) null; 1 at 0 degrees of freedom
    double impossibleHits = 0.0; ///< observed in cells that expect exactly 0; any makes pValue 0
};

/// Pearson's chi^2 test of a histogram against the counts its density predicts.
///
/// Pooling goes by order, never into one global bin, and looks at `expected` alone; a remainder
/// joins the last group. So list the cells in spatial (or distribution function) order.
///
/// \param observed  Counts per cell, shape [cells].
/// \param expected  Expected counts, shape [cells], same order.
/// \throws std::invalid_argument  if the shapes differ, a table is empty, or an entry is negative
///                                or not finite.
ChiSquareResult chiSquareTest(std::span<const double> observed, std::span<const double> expected,
                              const ChiSquareConfig &config = {});

/// The same for cells that expect `sampleCount / cells` each; nothing is pooled.
///
/// \param sampleCount  All samples drawn. May exceed the sum of `observed`: samples that fell
///                     outside every cell are then missed where they should have been.
ChiSquareResult chiSquareEqualCells(std::span<const double> observed, double sampleCount);

/// p-value of the null "the rms relative density error is at most `tolerance`": the upper tail of
/// the noncentral chi^2 law with noncentrality sampleCount * tolerance^2. With it, more samples
/// never turn rounding errors into an accusation.
double toleranceZonePValue(double statistic, int degreesOfFreedom, double sampleCount,
                           double tolerance);

/// Density of the statistic when the rms error is exactly `tolerance`: for a picture of the test.
double toleranceZoneDensity(double statistic, int degreesOfFreedom, double sampleCount,
                            double tolerance);

/// The statistic from which on a test at this level rejects.
double toleranceZoneCritical(double level, int degreesOfFreedom, double sampleCount,
                             double tolerance);

/// Estimate of the rms relative density error over the cells, sqrt(max(0, X^2 - df) / N).
double rmsErrorEstimate(double statistic, int degreesOfFreedom, double sampleCount);

/// Upper confidence bound (at 1 - `level`) of the rms relative density error over the cells.
double rmsErrorUpperBound(double statistic, int degreesOfFreedom, double sampleCount,
                          double level = 1e-4);

struct DetectableErrorConfig {
    double significance = 1e-4;
    double power = 0.999;
    double tolerance = 0.0; ///< of the null hypothesis, see toleranceZonePValue()
};

/// Minimal detectable rms relative density error: the one that a test of `sampleCount` samples
/// rejects with the given power.
double rmsErrorDetectable(int degreesOfFreedom, double sampleCount,
                          const DetectableErrorConfig &config = {});

} // namespace statistics
