// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "grading.h"
#include "patch.h"

namespace exam {

/// What one grading made of a patch.
struct Judgement {
    bool asExpected = false; ///< it costs what it must, and nothing else
    bool lost = false;       ///< its item lost points; for a blemish: it has a remark
    bool othersFull = true;
    std::size_t diagnosisRank = 0; ///< of a right diagnosis, from 1; 0: none is right
    std::string got;               ///< what was lost, and the first diagnosis
};

/// Ids of the diagnoses of an item, or sentences where there are no ids; what is told first is
/// first.
std::vector<std::string> diagnosesOf(const GradedItem &item);

Judgement judge(const Patch &patch, const Graded &graded);

} // namespace exam
