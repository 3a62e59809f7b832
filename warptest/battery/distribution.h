// SPDX-License-Identifier: MIT
#pragma once

#include <battery/records.h>
#include <battery/unit_square.h>
#include <statistics/triple_lock.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace battery {

/// Samples of one distribution test at stage 0 of the triple lock. 2^20 at 4 and 16 times in the
/// later stages; an rms error of 1.9 % is found at once.
inline constexpr std::size_t kDistributionSamples = std::size_t{1} << 20U;
/// A pass needs the upper bound of the rms density error below this.
inline constexpr double kDistributionPassLimit = 0.02;

/// Counts in equal cells of the unit square, u slowest.
struct Histogram {
    int uBins = 0;
    int vBins = 0;
    std::vector<double> counts{};
};

/// What judgeDistribution() tests: 32x32, 8x8, U in 256 bins, V in 256 bins.
std::array<Histogram, 4> countHistograms(const UnitSquarePoints &points);

/// Pearson's test on one histogram, against the null "rms error <= tolerance".
struct HistogramTest {
    int uBins = 0;
    int vBins = 0;
    double statistic = 0.0;
    int degreesOfFreedom = 0;
    double tolerance = 0.0; ///< rms relative density error that is excused
    double pValue = 1.0;
    double rmsError = 0.0; ///< estimate
    double rmsBound = 0.0; ///< upper confidence bound at 99.99 %
    double mde = 0.0;      ///< found with power 0.999 at 1e-4
};

struct DistributionResult {
    std::size_t total = 0;
    std::size_t invalid = 0;   ///< outputs out of the domain; they are missed in the histograms
    std::size_t poleAtoms = 0; ///< directions exactly at the pole: above 1e-5 a loss of precision
    std::array<HistogramTest, 4> tests{};      ///< of countHistograms()
    double pValue = 1.0;                       ///< of the four together: min(1, 4 min p)
    double rmsError = 0.0;                     ///< the larger estimate of 32x32 and 8x8
    double rmsBound = 0.0;                     ///< of 8x8: what a pass states
    double passLimit = kDistributionPassLimit; ///< for rmsBound; wider where rounding demands it
    double mde = 0.0;                          ///< of 8x8
    double z = 0.0; ///< the largest deviation of the four, in standard deviations
    /// Where the 8x8 histogram is worst: cell indices, and (observed - expected) / expected.
    int worstU = 0;
    int worstV = 0;
    double worstRelative = 0.0;
    std::vector<double> counts;    ///< 32x32, u slowest, for a heat map
    std::vector<double> deviation; ///< 32x32 signed standardised residuals
};

/// Tests outputs of independent random inputs against the exact distribution, by mapping them to
/// the unit square, where every right warp is uniform.
/// \throws std::invalid_argument  if there are no outputs.
DistributionResult judgeDistribution(const catalog::WarpEntry &entry, double a,
                                     std::span<const Output> outputs);

/// For tripleLock(), with LockConfig from distributionLock().
statistics::StageResult asStage(const DistributionResult &result);
statistics::LockConfig distributionLock(const catalog::WarpEntry &entry, double a);

} // namespace battery
