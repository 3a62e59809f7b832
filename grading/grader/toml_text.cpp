// SPDX-License-Identifier: MIT
#include "toml_text.h"

#include <grader/error.h>

#include <fmt/format.h>
#include <unicode/unistr.h>

#include <algorithm>

namespace grader {

namespace {

// toml++ 3.3 asks of many a character whether it is a blank, and answers for most from U+00A1 to
// U+FEFE with undefined behaviour (is_non_ascii_horizontal_whitespace()): a key `latent_fracción`,
// a letter behind `\` in a text of several lines. So it is given all of them in plane 16.
constexpr UChar32 kFirst = 0x80;
constexpr UChar32 kLast = 0xfeff;
constexpr UChar32 kPlane16 = 0x100000;

/// The same text with all characters from `first` to `last` moved.
std::string moved(const icu::UnicodeString &text, UChar32 first, UChar32 last, UChar32 by) {
    icu::UnicodeString result;
    for (int i = 0; i < text.length(); i = text.moveIndex32(i, 1)) {
        const UChar32 c = text.char32At(i);
        result.append(c >= first && c <= last ? c + by : c);
    }
    std::string utf8;
    result.toUTF8String(utf8);
    return utf8;
}

icu::UnicodeString fromUtf8(std::string_view utf8) {
    return icu::UnicodeString::fromUTF8(icu::StringPiece(utf8));
}

std::string movedBack(std::string_view utf8) {
    return moved(fromUtf8(utf8), kPlane16 + kFirst, kPlane16 + kLast, -kPlane16);
}

[[noreturn]] void fail(const std::string &name, std::string_view before, const char *what) {
    const std::size_t lineEnd = before.rfind('\n');
    throw GraderError(fmt::format(
        "{}:{}:{}: {}", name, std::count(before.begin(), before.end(), '\n') + 1,
        lineEnd == std::string_view::npos ? before.size() + 1 : before.size() - lineEnd, what));
}

icu::UnicodeString decode(std::string_view utf8, const std::string &name) {
    icu::UnicodeString text = fromUtf8(utf8);
    std::string back;
    text.toUTF8String(back); // what is malformed comes back as U+FFFD
    const auto fault = std::mismatch(utf8.begin(), utf8.end(), back.begin(), back.end()).first;
    if (fault != utf8.end())
        fail(name, utf8.substr(0, static_cast<std::size_t>(fault - utf8.begin())),
             "is not UTF-8; save it in that encoding");
    for (const char *plane16 : {"\xf4", "\\U0010"}) {
        if (const std::size_t at = utf8.find(plane16); at != std::string_view::npos)
            fail(name, utf8.substr(0, at), "a letter of plane 16, which is for private use");
    }
    return text;
}

[[noreturn]] void fail(const std::string &name, const toml::source_region &where,
                       const std::string &what) {
    throw GraderError(
        fmt::format("{}:{}:{}: {}", name, where.begin.line, where.begin.column, what));
}

void moveBack(toml::node &node, const std::string &name) {
    if (toml::table *table = node.as_table()) {
        for (auto &&[key, value] : *table) {
            if (!std::all_of(key.begin(), key.end(), [](unsigned char c) { return c < 0x80; }))
                fail(name, key.source(),
                     fmt::format("the key '{}' has letters beyond ASCII", movedBack(key.str())));
            moveBack(value, name);
        }
    } else if (toml::array *array = node.as_array()) {
        for (toml::node &value : *array)
            moveBack(value, name);
    } else if (toml::value<std::string> *value = node.as_string()) {
        value->get() = movedBack(value->get());
    }
}

} // namespace

toml::table parseToml(std::string_view text, const std::string &name) {
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (text.substr(0, kByteOrderMark.size()) == kByteOrderMark)
        text.remove_prefix(kByteOrderMark.size());
    try {
        toml::table table = toml::parse(moved(decode(text, name), kFirst, kLast, kPlane16), name);
        moveBack(table, name);
        return table;
    } catch (const toml::parse_error &error) {
        fail(name, error.source(), movedBack(error.description()));
    }
}

} // namespace grader
