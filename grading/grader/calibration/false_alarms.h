// SPDX-License-Identifier: MIT
#pragma once

#include <grader/checks/check.h>
#include <grader/rubric/rubric.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace grader {

/// How often single stages rejected right code at the level of the first stage, as it was counted
/// where they do so most often: the cube of a mean level is no bound of the mean of the cubes.
struct StageLevel {
    Evidence evidence = Evidence::Fixed;
    std::string how; ///< command, commit, and what was right
    std::uint64_t runs = 0;
    std::uint64_t rejections = 0;

    /// One-sided 95 % upper confidence bound of the chance to reject (Clopper and Pearson).
    double bound() const;
};

/// Reads stage_levels.toml.
/// \throws GraderError  with file:line:column, on anything unknown, missing or out of range
std::vector<StageLevel> readStageLevels(const std::filesystem::path &file);

/// Checks whose accusations rest on the same evidence.
struct FalseAlarmPart {
    Evidence evidence = Evidence::Fixed;
    std::vector<std::string> checks;
    int locks = 0;                      ///< of all of them together
    std::optional<StageLevel> measured; ///< none: the nominal levels went in
    double perLock = 0;                 ///< that all three stages reject right code
    double perHandIn = 0;
};

/// Chance that right code of a class loses anything: a union bound over all locks of three
/// independent stages, composed of the levels of single stages; the whole was never measured.
struct FalseAlarmBound {
    std::vector<FalseAlarmPart> parts;
    double perHandIn = 0;
    double perClass = 0;
    std::vector<std::string> unbounded; ///< checks that decide by a fixed tolerance instead
};

/// \param levels  a measured one stands for all three stages, as the third one, at a tenth of the
///                level, rejects no more often
FalseAlarmBound composeBound(const Rubric &rubric, const std::vector<Check> &table,
                             const std::vector<StageLevel> &levels, int classSize);

/// Lines for people.
std::string describeBound(const FalseAlarmBound &bound, int classSize);

} // namespace grader
