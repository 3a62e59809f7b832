// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace grader {

/// The name that was probably meant: the one that takes the fewest letters inserted, deleted or
/// replaced. \return  empty if none is near (more than a third of the letters, at least one,
/// differ)
std::string nearestName(std::string_view name, const std::vector<std::string> &known);

/// ` (did you mean "cap"?)`, or ` (known: cap, extras)` when nothing is near.
std::string suggestion(std::string_view name, const std::vector<std::string> &known);

} // namespace grader
