// SPDX-License-Identifier: MIT
#pragma once

#include <battery/records.h>
#include <statistics/triple_lock.h>

#include <cstddef>
#include <span>
#include <vector>

namespace battery {

/// Side of the stratified inputs that the threshold of the smooth moments is measured for.
inline constexpr int kStratifiedSide = 1024;

struct StratifiedResult {
    std::size_t total = 0;
    std::size_t invalid = 0; ///< outputs out of the domain, left out of the moments
    double maxMoment = 0.0;  ///< largest |smooth moment|; about the amplitude of the density error
    double threshold = 0.0;  ///< never exceeded by a right warp
    std::size_t momentIndex = 0; ///< of the largest, in the order of StratifiedMoments
    std::vector<double> moments; ///< all 90, signed

    /// Also true when no output at all is in the domain.
    [[nodiscard]] bool exceeds() const { return invalid == total || maxMoment > threshold; }
};

/// Judges the outputs of stratifiedInputs(side, ...), in any order. Far more sensitive than
/// judgeDistribution() to smooth errors, blind to fine ones; outputs out of the domain are for
/// judgeRange().
/// \throws std::invalid_argument  if there are no outputs or they are not a square number.
StratifiedResult judgeStratified(const catalog::WarpEntry &entry, double a,
                                 std::span<const Output> outputs);

/// For tripleLock() (p-value 0 or 1: the threshold lies far above any noise). Every stage should
/// use the same side, with fresh seeds.
statistics::StageResult asStage(const StratifiedResult &result);

} // namespace battery
