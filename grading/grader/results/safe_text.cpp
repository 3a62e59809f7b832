// SPDX-License-Identifier: MIT
#include "safe_text.h"

#include <fmt/format.h>
#include <unicode/uchar.h>
#include <unicode/unistr.h>

#include <iterator>

namespace grader {

namespace {

icu::UnicodeString decode(std::string_view text) {
    return icu::UnicodeString::fromUTF8(
        icu::StringPiece(text.data(), static_cast<std::int32_t>(text.size())));
}

/// Calls `visit` with each code point of `text`; lone surrogates cannot occur (fromUTF8).
template <typename Visit>
void forEachCodePoint(const icu::UnicodeString &text, Visit &&visit) {
    for (std::int32_t i = 0; i < text.length(); i = text.moveIndex32(i, 1))
        visit(text.char32At(i));
}

/// Controls (Cc), format characters (Cf: bidirectional overrides, zero-width ones, tags) and line
/// and paragraph separators. Joiners shape some scripts, but no text here needs them to be read.
bool isInvisible(UChar32 c) {
    switch (u_charType(c)) {
    case U_CONTROL_CHAR:
    case U_FORMAT_CHAR:
    case U_LINE_SEPARATOR:
    case U_PARAGRAPH_SEPARATOR:
        return true;
    default:
        return false;
    }
}

std::string safe(std::string_view text, bool keepLines) {
    icu::UnicodeString kept;
    forEachCodePoint(decode(text), [&](UChar32 c) {
        if ((c == '\n' && !keepLines) || c == '\t')
            kept.append(UChar32{' '});
        else if (c == '\n' || !isInvisible(c))
            kept.append(c);
    });
    std::string result;
    return kept.toUTF8String(result);
}

} // namespace

std::string safeLine(std::string_view text) {
    return safe(text, false);
}

std::string safeLines(std::string_view text) {
    return safe(text, true);
}

std::string escapeInvisible(std::string_view json) {
    std::string result;
    result.reserve(json.size());
    forEachCodePoint(decode(json), [&](UChar32 c) {
        if (c < 0x7f) // JSON's own line ends; other C0 characters were escaped by its writer
            result.push_back(static_cast<char>(c));
        else if (!isInvisible(c))
            icu::UnicodeString(c).toUTF8String(result);
        else if (c <= 0xffff)
            fmt::format_to(std::back_inserter(result), "\\u{:04x}", static_cast<unsigned>(c));
        else
            fmt::format_to(std::back_inserter(result), "\\u{:04x}\\u{:04x}",
                           static_cast<unsigned>(0xd800 + ((c - 0x10000) >> 10)),
                           static_cast<unsigned>(0xdc00 + ((c - 0x10000) & 0x3ff)));
    });
    return result;
}

} // namespace grader
