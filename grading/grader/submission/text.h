// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace grader {

/// A text file as the grader uses it.
struct NormalizedText {
    std::string text; ///< LF line ends, no byte-order mark; the other bytes as they were
    bool wasUtf16 = false;
    bool hasNul = false; ///< no text: do not use it
};

/// Takes away what editors and systems add to a text: byte-order mark, CR LF, UTF-16. Bytes beyond
/// ASCII stay as they are (Latin-1 in a comment is no fault).
NormalizedText normalizeText(std::string_view bytes);

} // namespace grader
