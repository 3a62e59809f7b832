// SPDX-License-Identifier: MIT
#include "text_layout.h"

#include <unicode/uchar.h>
#include <unicode/unistr.h>

namespace grader {

namespace {

std::size_t columnsOf(UChar32 c) {
    const auto type = u_charType(c);
    if (type == U_NON_SPACING_MARK || type == U_ENCLOSING_MARK || type == U_FORMAT_CHAR)
        return 0;
    const int width = u_getIntPropertyValue(c, UCHAR_EAST_ASIAN_WIDTH);
    return width == U_EA_FULLWIDTH || width == U_EA_WIDE ? 2 : 1;
}

icu::UnicodeString decode(std::string_view text) {
    return icu::UnicodeString::fromUTF8(
        icu::StringPiece(text.data(), static_cast<std::int32_t>(text.size())));
}

/// Bytes of the longest beginning of `text` that fits into `width` columns; at least one character.
std::size_t fittingBytes(std::string_view text, std::size_t width) {
    const icu::UnicodeString decoded = decode(text);
    std::string head;
    std::size_t columns = 0;
    for (std::int32_t i = 0; i < decoded.length(); i = decoded.moveIndex32(i, 1)) {
        const UChar32 c = decoded.char32At(i);
        columns += columnsOf(c);
        if (columns > width && !head.empty())
            break;
        icu::UnicodeString(c).toUTF8String(head);
    }
    return head.size();
}

} // namespace

std::size_t displayWidth(std::string_view text) {
    const icu::UnicodeString decoded = decode(text);
    std::size_t columns = 0;
    for (std::int32_t i = 0; i < decoded.length(); i = decoded.moveIndex32(i, 1))
        columns += columnsOf(decoded.char32At(i));
    return columns;
}

std::string padRight(const std::string &text, std::size_t width) {
    const std::size_t columns = displayWidth(text);
    return columns < width ? text + std::string(width - columns, ' ') : text;
}

std::string padLeft(const std::string &text, std::size_t width) {
    const std::size_t columns = displayWidth(text);
    return columns < width ? std::string(width - columns, ' ') + text : text;
}

std::vector<std::string> wrapText(std::string_view text, std::size_t width) {
    if (width == 0)
        return {std::string(text)};
    std::string valid; // so that cutting a word counts the bytes that are there
    decode(text).toUTF8String(valid);
    std::vector<std::string> lines(1);
    for (std::string_view rest = valid; !rest.empty();) {
        const std::size_t end = std::min(rest.find(' '), rest.size());
        std::string_view word = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        const std::size_t used = displayWidth(lines.back());
        if (used > 0 && used + 1 + displayWidth(word) > width)
            lines.emplace_back();
        else if (used > 0 && !word.empty())
            lines.back() += ' ';
        while (displayWidth(word) > width && fittingBytes(word, width) < word.size()) {
            const std::size_t bytes = fittingBytes(word, width);
            lines.back() += word.substr(0, bytes);
            lines.emplace_back();
            word.remove_prefix(bytes);
        }
        lines.back() += word;
    }
    return lines;
}

} // namespace grader
