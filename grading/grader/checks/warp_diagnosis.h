// SPDX-License-Identifier: MIT
#pragma once

#include <battery/density.h>
#include <battery/nearest_mistake.h>
#include <battery/range.h>
#include <grader/diagnosis/guess.h>

#include <string>
#include <string_view>
#include <vector>

namespace grader {

/// The diagnosis of a mistake of warptest's catalogue: its own, `disk.missing_sqrt`, or the one
/// that several warps share, `warp.half_turn`.
/// \param mistake  id of the mistake; of a density with `pdf_` before it
/// \return         empty if there is none (tested)
std::string warpDiagnosis(std::string_view warp, std::string_view mistake);

/// What points of a wrong distribution look like: known mistakes by the part that they explain.
std::vector<Guess> guessSamples(const catalog::WarpEntry &warp, double parameter,
                                const std::vector<battery::Output> &outputs);

/// The same for points that leave the domain.
std::vector<Guess> guessRange(const catalog::WarpEntry &warp, double parameter,
                              const battery::RangeResult &range,
                              const std::vector<battery::Output> &outputs);

/// What a wrong density is: a known one, or the law of its ratio to the true one.
/// \param outside  what is outside the support was judged
std::vector<Guess> guessDensity(const catalog::WarpEntry &warp,
                                const battery::DensityResult &density, bool outside);

} // namespace grader
