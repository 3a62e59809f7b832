// SPDX-License-Identifier: MIT
#pragma once

#include <grader/prober/prober.h>
#include <grader/results/results.h>

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace grader {

/// What a check may do: ask the student's code, ask ours, and derive fresh random numbers.
/// ask() asks the variant under test: the student's part, and upstream parts as the engine chose.
class CheckContext : public ProbeClient {
public:
    /// Asks our own complete implementation the same.
    virtual ProbeAnswer askReference(const protocol::RequestGroup &group) = 0;

    /// A seed that depends on the run, the check, and these, and on nothing else.
    virtual std::uint64_t seed(std::string_view purpose, int stage = 0,
                               int replicate = 0) const = 0;
};

/// Levels 1e-4, 1e-4 and 1e-5 of three stages with fresh random numbers (statistics.md 2.0).
constexpr double kTripleLockLevel = 1e-13;

/// One row of the check table.
struct Check {
    std::string id;       ///< `warp.triangle.density`
    std::string item;     ///< rubric item id
    std::string group;    ///< whose code it judges: a row of the engine's group table, `warp`
    std::string what;     ///< one sentence for people: what is claimed of right code
    double tolerance = 0; ///< default of RubricCheck::tolerance
    double gross = 0;     ///< default of RubricCheck::gross
    /// Chance that right code fails, composed of the levels of the stages that have to agree; NaN
    /// where one comparison with a fixed tolerance decides instead.
    double falseAlarm = kTripleLockLevel;
    std::function<CheckResult(CheckContext &)> run;
};

/// All checks, in the order in which they are run.
const std::vector<Check> &checkTable();

/// \return  nullptr if there is none
const Check *findCheck(std::string_view id);

} // namespace grader
