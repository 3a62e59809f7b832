// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace grader {

/// The members of a hand-in, from the name that the handout asks for: `p2_NIP1_NIP2` or `p2_NIP1`.
struct NamedMembers {
    std::vector<std::string> members; ///< NIPs in the order of the name
    bool asAsked = false;             ///< false if more than the NIPs stands in the name
    std::string assignment;           ///< `p2`, lower case; empty if no NIP was found
};

/// \param name  Of a zip or folder, without extension; Moodle's prefixes are passed over.
NamedMembers parseMembers(std::string_view name);

/// NIPs that a README gives for its authors, sorted; empty where it gives none for certain. Only
/// numbers as long as those of `members` count, on lines around a word such as NIP or author.
std::vector<std::string> findNips(std::string_view readme, const std::vector<std::string> &members);

} // namespace grader
