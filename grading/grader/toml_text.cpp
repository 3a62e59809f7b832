// SPDX-License-Identifier: MIT
#include "toml_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace grader {

namespace {

struct TomlFault {
    std::size_t at;
    const char *what;
};

constexpr const char *kStrayLetter = "a letter beyond ASCII outside of quotation marks; keys are "
                                     "written in ASCII, texts in quotation marks";
constexpr const char *kMarkInNumber =
    "a quotation mark in what begins like a number; put a space before it, or the whole in marks";

bool isBeyondAscii(char c) {
    return static_cast<unsigned char>(c) >= 0x80;
}

/// Where one is in a TOML file, as far as characters beyond ASCII go.
class TomlScanner {
public:
    explicit TomlScanner(std::string_view text) : m_text(text) {}

    std::optional<TomlFault> findFault() {
        if (startsWith("\xef\xbb\xbf")) // a byte order mark
            m_at += 3;
        bool inWord = false;
        while (m_at < m_text.size()) {
            const char c = m_text[m_at];
            if (isBeyondAscii(c))
                return TomlFault{m_at, kStrayLetter};
            if (c == '#') {
                skipLine();
                inWord = false;
            } else if (c == '"' || c == '\'') {
                skipText(c);
            } else if (!inWord && beginsNumber(c)) {
                if (const auto fault = skipNumber())
                    return fault;
            } else {
                inWord = std::string_view(" \t\v\f\r\n=,[]{}").find(c) == std::string_view::npos;
                ++m_at;
            }
        }
        return std::nullopt;
    }

private:
    bool startsWith(std::string_view what) const {
        return m_text.substr(m_at, what.size()) == what;
    }

    /// Whatever toml++ takes for the end of a line, be it a right one or not.
    bool skipLineEnd() {
        for (const std::string_view end :
             {"\n", "\v", "\f", "\r", "\xc2\x85", "\xe2\x80\xa8", "\xe2\x80\xa9"}) {
            if (startsWith(end)) {
                m_at += end.size();
                return true;
            }
        }
        return false;
    }

    static bool beginsNumber(char c) { return (c >= '0' && c <= '9') || c == '+' || c == '-'; }

    /// toml++ looks ahead to the end of what begins like a number, and past one space, as a time
    /// may follow a date: a quotation mark on its way opens no text for it.
    std::optional<TomlFault> skipNumber() {
        for (bool spaceSeen = false; m_at < m_text.size(); ++m_at) {
            const char c = m_text[m_at];
            if (c == ' ' && !spaceSeen)
                spaceSeen = true;
            else if (isBeyondAscii(c) ||
                     std::string_view(" \t\v\f\r\n],}#").find(c) != std::string_view::npos)
                break;
            else if ((c == '"' || c == '\'') && hasBeyondAscii(m_at))
                return TomlFault{m_at, kMarkInNumber};
        }
        return std::nullopt;
    }

    bool hasBeyondAscii(std::size_t from) const {
        return std::any_of(m_text.begin() + static_cast<std::ptrdiff_t>(from), m_text.end(),
                           isBeyondAscii);
    }

    void skipLine() {
        while (m_at < m_text.size() && !skipLineEnd())
            ++m_at;
    }

    /// From the quotation mark to the one that ends it, or the end of a line that has none.
    void skipText(char mark) {
        const std::string three(3, mark);
        const bool hasLines = startsWith(three);
        m_at += hasLines ? 3 : 1;
        while (m_at < m_text.size()) {
            if (mark == '"' && m_text[m_at] == '\\') {
                m_at = std::min(m_at + 2, m_text.size());
            } else if (hasLines && startsWith(three)) {
                // Two marks may stand before the three that end it.
                for (int i = 0; i < 5 && m_at < m_text.size() && m_text[m_at] == mark; ++i)
                    ++m_at;
                return;
            } else if (!hasLines && m_text[m_at] == mark) {
                ++m_at;
                return;
            } else if (!hasLines && skipLineEnd()) {
                return;
            } else {
                ++m_at;
            }
        }
    }

    std::string_view m_text;
    std::size_t m_at = 0;
};

} // namespace

std::string tomlFault(std::string_view text) {
    const std::optional<TomlFault> fault = TomlScanner(text).findFault();
    if (!fault)
        return {};
    const std::string_view before = text.substr(0, fault->at);
    const std::size_t line = before.rfind('\n');
    return fmt::format("{}:{}: {}", std::count(before.begin(), before.end(), '\n') + 1,
                       line == std::string_view::npos ? fault->at + 1 : fault->at - line,
                       fault->what);
}

} // namespace grader
