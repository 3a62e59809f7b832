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
///          binomial 99.9 % limits
bool runNull(int runs, std::uint64_t seed);

/// Mistakes planted in correct code, at fixed numbers of samples: prints how often each statistic
/// finds them, and how often its noise promises that. \return  whether every rate is what was
/// promised, within its binomial 99.9 % limits, and nearly 1 from the minimal detectable error on
/// \param only  part of the mistakes' names
bool runPowerOfStatistics(int runs, const std::string &only, std::uint64_t seed);

/// How whole judgements of the grader end on them. \return  whether right code never fails, and
/// what no pass allows fails in 99.9 % of them, within the binomial 99.9 % limits
bool runJudgements(int judgements, const std::string &only, std::uint64_t seed);

/// How often the first of three stages rejects correct code in whole judgements of the grader, for
/// each kind of evidence of stage_levels.toml that is not counted by `./run warp-calibrate`; the
/// part that rejects most often stands for its kind. \param only  part of the kinds' names: cells,
/// images, noise \throws std::runtime_error  if correct code is accused, or a planted mistake is
/// not
void runStages(int judgements, const std::string &only, std::uint64_t seed);

} // namespace calibration
