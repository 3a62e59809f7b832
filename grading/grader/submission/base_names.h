// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The base's files, by which those of a hand-in are recognised wherever they lie.
namespace grader {

struct BaseName {
    std::string name; ///< in the base's spelling
    bool isHeader = false;
    bool isReplaceable = false; ///< else it stays the grader's own
};

/// The base's file with this name in any case, if there is one.
std::optional<BaseName> findBaseName(std::string_view name);

/// The replaceable sources, sorted.
const std::vector<std::string> &replaceableSources();

/// Lower-case stems of all sources of the base.
const std::vector<std::string> &baseStems();

} // namespace grader
