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
    std::size_t humans = 0; ///< other items at which a person must look; they keep their points
    std::size_t diagnosisRank = 0; ///< of a right diagnosis, from 1; 0: none is right
    std::string diagnosis;         ///< the right one's id; may be empty
    std::string got;               ///< what was lost, and the first diagnosis
};

/// Ids of diagnoses that a check gives of whatever is wrong there, where no known mistake fits:
/// they say what is not as it should be, and not why.
const std::vector<std::string> &catchAlls();

/// Ids of the diagnoses of an item, or of its checks where it has none; what is told first is
/// first.
std::vector<std::string> diagnosesOf(const GradedItem &item);

Judgement judge(const Patch &patch, const Graded &graded);

} // namespace exam
