// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace grader {

/// Columns that UTF-8 text takes in a terminal: combining marks none, wide East Asian characters
/// two.
std::size_t displayWidth(std::string_view text);

/// Adds spaces up to `width` columns; longer text stays as it is.
std::string padRight(const std::string &text, std::size_t width);
std::string padLeft(const std::string &text, std::size_t width);

/// Breaks one line at spaces into lines of at most `width` columns; a longer word is cut.
/// \param width  0: never break
/// \return  at least one line
std::vector<std::string> wrapText(std::string_view text, std::size_t width);

} // namespace grader
