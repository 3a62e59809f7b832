// SPDX-License-Identifier: MIT
#pragma once

#include <grader/checks/radiance_case.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace grader {

constexpr double kGrossRadiance = 0.05; ///< default of Check::gross, of the radiance asked about

/// Makes the scene from the check's seed for the purpose "scene".
using CaseMaker = RadianceCase (*)(std::uint64_t seed);

/// Asks the code under test about further scenes, to name its mistake.
using Experimenter = std::vector<Guess> (*)(CheckContext &);

/// A row of the item `direct_ems`.
/// \param name  without the item's
Check directEmsCheck(const char *name, const char *what,
                     std::function<CheckResult(CheckContext &)> run, double tolerance,
                     double gross);

/// One that judges what Li is on average.
/// \param experiment  made after a failure; may be null
/// \param gross       Check::gross
Check radianceCheck(const char *name, const char *what, CaseMaker make,
                    Experimenter experiment = nullptr, double gross = kGrossRadiance);

} // namespace grader
