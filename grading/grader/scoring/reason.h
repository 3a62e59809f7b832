// SPDX-License-Identifier: MIT
#pragma once

#include <grader/results/results.h>
#include <grader/rubric/rubric.h>

#include <string>

namespace grader {

/// One line on why an item has the points it has: the costliest defect with its diagnosis and how
/// many more there are; else what stands, what could not be told, and how many remarks there are.
///
/// \param result  with `checks` scored, in the order of `item.checks`, and `points`
std::string reasonFor(const RubricItem &item, const ItemResult &result);

} // namespace grader
