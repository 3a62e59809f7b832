// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace grader {

/// What a C++ source visibly defines. A look at the text, not a parser: good enough to tell a copy
/// of a file from a file of its own.
struct SourceScan {
    std::set<std::string> registeredTypes; ///< second argument of NORI_REGISTER_CLASS
    std::set<std::string> definitions;     ///< `Mesh::samplePosition` and the registered classes

    bool sharesWith(const SourceScan &other) const;
};

SourceScan scanSource(std::string_view text);

} // namespace grader
