// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace grader {

/// Text from a hand-in may hold anything: bytes that are no UTF-8, terminal escapes, characters
/// that turn the direction of writing. These make it safe to show; none of them knows a format.

/// Valid UTF-8 of one line: what is invalid becomes U+FFFD, line ends and tabs become spaces,
/// control and bidirectional-override characters go.
std::string safeLine(std::string_view text);

/// The same, but keeps line ends.
std::string safeLines(std::string_view text);

/// Escapes what a terminal or a reader would not see (DEL, C1, bidirectional and other invisible
/// controls) in a JSON document as `\uXXXX`: the same document, plainly readable.
std::string escapeInvisible(std::string_view json);

} // namespace grader
