// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace calibration {

/// The scenes of scenes/grading in which everything is calibrated.
const std::vector<std::string> &sceneNames();

/// Correct code against itself, `runs` times per scene: prints, for every statistic, the
/// Kolmogorov-Smirnov test of its p-values and how often they fall below 1e-2 and 1e-3.
/// \return  whether all agree with the uniform law: KS p at least 1e-3, exceedances within their
///          binomial 99.9 % limits (only not above, for statistics that are conservative)
bool runNull(int runs, std::uint64_t seed);

/// Mistakes planted in correct code: prints how often the global statistic finds each, and how
/// often its standard error promises that; then how whole judgements end. \return  whether every
/// rate is what was promised, within its binomial 99.9 % limits
bool runPower(int runs, int judgements, std::uint64_t seed);

} // namespace calibration
