// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "grading.h"

namespace exam {

/// Hand-ins that are graded again and again.
enum class Standing {
    Accepted,   ///< right: every point, always
    Borderline, ///< wrong by what can just be found: points may differ by a little
    Wrong,      ///< the same points, always, and not all of them
};

/// How often a check said what: by verdict.
using VerdictCounts = std::map<std::string, int>;

/// All gradings of one hand-in.
struct StabilityRecord {
    std::string name;
    std::string what; ///< in a sentence; may be empty
    Standing standing = Standing::Accepted;
    std::vector<Graded> seeds; ///< one process, -O2; one per seed
    std::vector<Graded> pairs; ///< the first seeds again, with two processes
    std::vector<Graded> plain; ///< the first seeds again, with the hand-in built with -O0

    /// Points of all items together, before the rubric's cap hides a difference.
    static double points(const Graded &graded);

    double smallest() const, largest() const;
    /// Of the points over the seeds.
    double standardDeviation() const;
    /// Checks that do not say the same with every seed.
    std::map<std::string, VerdictCounts> changingChecks() const;

    /// Whether it is as stable as its standing asks.
    bool asExpected() const;
};

/// Where another setting gave another verdict with the same seed.
struct VerdictChange {
    std::string check;
    std::string before, after;

    bool isHarmless() const; ///< pass and inconclusive cost the same: nothing
};

/// \param exactly  also tell of checks that say the same, in other numbers
std::vector<VerdictChange> verdictChanges(const Graded &before, const Graded &after, bool exactly);

/// A table for people, and for the record as Markdown.
std::string describeStability(const std::vector<StabilityRecord> &records);
std::string stabilityMarkdown(const std::vector<StabilityRecord> &records,
                              const std::string &commit);

/// The verb `stability`.
/// \param argv  from the verb on
/// \return      the exit code: 0 as it has to be, 1 not, 2 usage, 75 interrupted
/// \throws ExamError  if the grader fails
int measureStability(int argc, char **argv);

} // namespace exam
