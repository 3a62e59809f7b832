// SPDX-License-Identifier: MIT
#pragma once

#include <grader/checks/radiance_case.h>

#include <vector>

namespace grader {

constexpr double kGrossRadiance = 0.05; ///< of the radiance that is asked about

using CaseMaker = RadianceCase (*)(std::uint64_t seed);
using Experimenter = std::vector<Guess> (*)(CheckContext &);

/// A row of the item `direct_ems` that judges what Li is on average.
/// \param name        without the item's
/// \param experiment  made after a failure, for the diagnosis
Check radianceCheck(const char *name, const char *what, CaseMaker make,
                    Experimenter experiment = nullptr, double gross = kGrossRadiance);

} // namespace grader
