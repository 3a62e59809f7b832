// SPDX-License-Identifier: MIT
#pragma once

#include <battery/records.h>
#include <catalog/density_mistakes.h>
#include <catalog/density_ratio.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace battery {

/// Why a density is asked at a point.
enum class QueryKind : unsigned char {
    Target,  ///< drawn from the exact distribution: where samples really fall
    Domain,  ///< uniform on the enlarged domain: in and outside of the support
    Boundary ///< a few units in the last place on either side of the support's boundary
};

struct DensityQueries {
    std::vector<Output> points;
    std::vector<QueryKind> kinds; ///< shape as `points`, in groups of equal kind
};

/// `count` points, about half from the target and half uniform on the enlarged domain, and at most
/// 1024 more at the boundary.
DensityQueries densityQueries(const catalog::WarpEntry &entry, double a, std::uint64_t seed,
                              std::size_t count = std::size_t{1} << 17U);

struct DensityResult {
    std::size_t targetPoints = 0;  ///< points drawn from the target, clear of the boundary
    std::size_t wrongAtTarget = 0; ///< of them, where the density is off by more than rounding
    std::size_t zeroAtTarget = 0;  ///< of the wrong ones, where it is 0
    double zeroDepth = 0.0;        ///< of those, the largest distance to the boundary
    double maxRelativeError = 0.0; ///< inside the support, where the density matters
    double medianRatio = 1.0;      ///< returned / exact, at the target points
    std::size_t worst = 0;         ///< index of the query with the largest relative error
    double worstExact = 0.0;       ///< exact density there

    std::size_t insidePoints = 0;   ///< uniform points inside the support, clear of its boundary
    std::size_t wrongInside = 0;    ///< of them, where the density is off by more than rounding
    std::size_t outsidePoints = 0;  ///< uniform points outside the support
    std::size_t nonZeroOutside = 0; ///< of them, where the density is not 0
    std::size_t worstOutside = 0;   ///< index of one of those with the largest |density|
    double outsideMass = 0.0;       ///< integral of the density over what is outside
    double outsideSize = 0.0;       ///< of its absolute value; infinite where a value is not finite

    std::size_t boundaryPoints = 0;
    std::size_t wrongAtBoundary = 0; ///< neither side's value: a remark, since of measure zero
    std::size_t notFinite = 0;       ///< anywhere but at the boundary
    std::size_t negative = 0;        ///< anywhere but at the boundary

    catalog::RatioLaw ratio; ///< the law of returned / exact inside the support, if one is found
    const catalog::DensityMistake *mistake = nullptr; ///< a known wrong density that fits, or null

    /// Part of the probability mass at which the density is wrong: what a grade should follow.
    [[nodiscard]] double wrongMass() const {
        return targetPoints > 0
                   ? static_cast<double>(wrongAtTarget) / static_cast<double>(targetPoints)
                   : 0.0;
    }

    /// Right inside the support up to a fraction of a thousandth (single unlucky roundings).
    [[nodiscard]] bool rightInside() const {
        return static_cast<double>(wrongAtTarget) <= 1e-3 * static_cast<double>(targetPoints) &&
               static_cast<double>(wrongInside) <= 1e-3 * static_cast<double>(insidePoints);
    }

    /// Zero wherever it must be.
    [[nodiscard]] bool rightOutside() const { return nonZeroOutside == 0; }
};

/// Compares a density with the exact one, point by point: a proof, not a test, so it needs no
/// confirmation. Within 1e-5 of the boundary of the support either side's value is accepted, and
/// densities below 1e-20, which single precision need not hold, may be anything up to 1e-15.
/// \param pdfs  What the density function returned, shape as `queries.points`.
/// \throws std::invalid_argument  if the shapes differ.
DensityResult judgeDensity(const catalog::WarpEntry &entry, double a, const DensityQueries &queries,
                           std::span<const float> pdfs);

} // namespace battery
