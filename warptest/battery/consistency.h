// SPDX-License-Identifier: MIT
#pragma once

#include <battery/records.h>
#include <statistics/quadrature.h>

#include <span>
#include <vector>

namespace battery {

/// Where to ask a density for judgeNormalisation(): exact warp of integrationNodes(), shape [5120].
std::vector<Output> normalisationPoints(const catalog::WarpEntry &entry, double a);

/// Integral of a density over the support, by the ratio to the exact density: the integrand of a
/// right one is 1, however narrow its peak. The integral over the rest of the domain is
/// DensityResult::outsideMass.
/// \param pdfs  At normalisationPoints(), shape [5120]; one that is not finite counts as 0.
/// \throws std::invalid_argument  if the shape differs.
statistics::QuadratureResult judgeNormalisation(const catalog::WarpEntry &entry, double a,
                                                std::span<const float> pdfs);

/// Where to ask a density for judgeConsistency(): 4x4 Gauss points in each of 32x32 cells of the
/// unit square, mapped by the exact warp, shape [16384].
std::vector<Output> consistencyPoints(const catalog::WarpEntry &entry, double a);

/// Does a warp sample the density that comes with it, right or wrong? For diagnosis and partial
/// credit only: "consistent, but the wrong distribution".
struct ConsistencyResult {
    double statistic = 0.0;
    int degreesOfFreedom = 0;
    double pValue = 1.0;        ///< against "rms error <= tolerance"
    double rmsError = 0.0;      ///< of the density against the samples
    double insideMass = 0.0;    ///< integral of the density over the support
    double insideSamples = 0.0; ///< part of the samples inside the support

    /// No significant difference at 1e-4.
    [[nodiscard]] bool consistent() const { return pValue > 1e-4; }
};

/// \param outputs  The warp's, of independent random inputs.
/// \param pdfs     The density at consistencyPoints(), shape [16384].
/// \throws std::invalid_argument  if the shape differs or there are no outputs.
ConsistencyResult judgeConsistency(const catalog::WarpEntry &entry, double a,
                                   std::span<const Output> outputs, std::span<const float> pdfs);

} // namespace battery
