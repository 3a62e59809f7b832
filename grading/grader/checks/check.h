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
    /// Asks our own complete implementation the same. It may have answered this to the same check
    /// before: then the answer, with its outcome, is that of then.
    virtual ProbeAnswer askReference(const protocol::RequestGroup &group) = 0;

    /// A seed that depends on the run, the check, and these, and on nothing else.
    virtual std::uint64_t seed(std::string_view purpose, int stage = 0,
                               int replicate = 0) const = 0;
};

/// What an accusation rests on, and so what its chance to meet right code is composed of.
enum class Evidence {
    Fixed,      ///< one comparison with a fixed tolerance, far above rounding and noise: no level
    WarpPoints, ///< three stages with fresh numbers: cells of a warp's independent points
    Cells,      ///< same: cells of points on meshes, of directions
    Images,     ///< same: means and tiles of images and rays
    Noise,      ///< same: errors of images against what their noise promises
};

/// One row of the check table.
struct Check {
    std::string id;       ///< `warp.triangle.density`
    std::string item;     ///< rubric item id
    std::string group;    ///< whose code it judges: a row of the engine's group table, `warp`
    std::string what;     ///< one sentence for people: what is claimed of right code
    std::string function; ///< the one that it calls; empty: any of the group's
    double tolerance = 0; ///< default of RubricCheck::tolerance
    double gross = 0;     ///< default of RubricCheck::gross
    Evidence evidence = Evidence::Fixed;
    /// A failure of it is charged where it shows, if anywhere: it excuses nobody who calls the
    /// code.
    bool excusesNobody = false;
    int locks = 1; ///< times that three stages could accuse: per parameter, per way of looking
    std::function<CheckResult(CheckContext &)> run;
};

/// All checks, in the order in which they are run: those of an item and function together.
const std::vector<Check> &checkTable();

/// \return  nullptr if there is none
const Check *findCheck(std::string_view id);

} // namespace grader
