// SPDX-License-Identifier: MIT
#include "toml_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace grader {

namespace {

/// Where one is in a TOML file, as far as characters beyond ASCII go.
class TomlScanner {
public:
    explicit TomlScanner(std::string_view text) : m_text(text) {}

    /// \return  offset of the first character that stands in no text and no comment; npos if none
    std::size_t findStray() {
        if (startsWith("\xef\xbb\xbf")) // a byte order mark
            m_at += 3;
        while (m_at < m_text.size()) {
            const char c = m_text[m_at];
            if (static_cast<unsigned char>(c) >= 0x80)
                return m_at;
            if (c == '#')
                skipLine();
            else if (c == '"' || c == '\'')
                skipText(c);
            else
                ++m_at;
        }
        return std::string_view::npos;
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
    const std::size_t at = TomlScanner(text).findStray();
    if (at == std::string_view::npos)
        return {};
    const std::string_view before = text.substr(0, at);
    const std::size_t line = before.rfind('\n');
    return fmt::format(
        "{}:{}: a letter beyond ASCII outside of quotation marks; keys are written in "
        "ASCII, texts in quotation marks",
        std::count(before.begin(), before.end(), '\n') + 1,
        line == std::string_view::npos ? at + 1 : at - line);
}

} // namespace grader
