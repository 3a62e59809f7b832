// SPDX-License-Identifier: MIT
#include <grader/submission/source_scan.h>

#include <algorithm>
#include <cctype>

namespace grader {

namespace {

bool isWordCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// The text without comments, each replaced by a blank.
std::string withoutComments(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    for (std::size_t i = 0; i < text.size();) {
        const std::string_view two = text.substr(i, 2);
        if (two == "//") {
            i = std::min(text.find('\n', i), text.size());
        } else if (two == "/*") {
            const std::size_t end = text.find("*/", i + 2);
            i = end == std::string_view::npos ? text.size() : end + 2;
            result += ' ';
        } else {
            result += text[i++];
        }
    }
    return result;
}

/// Moves over a text; each function returns what it passed.
class Cursor {
public:
    Cursor(std::string_view text, std::size_t at) : m_text(text), m_at(at) {}

    std::string word() {
        skipBlanks();
        std::string result;
        while (m_at < m_text.size() && isWordCharacter(m_text[m_at])) {
            result += m_text[m_at++];
        }
        return result;
    }

    bool symbol(char c) {
        skipBlanks();
        if (m_at >= m_text.size() || m_text[m_at] != c) {
            return false;
        }
        ++m_at;
        return true;
    }

    /// After an opening bracket: to behind the one that closes it. False if it is not near: the
    /// parameters of a function are never that long, and a hostile text must not cost a search to
    /// its end at each bracket.
    bool closeBracket() {
        constexpr std::size_t kNear = 2000;
        const std::size_t limit = std::min(m_text.size(), m_at + kNear);
        for (int depth = 1; m_at < limit;) {
            const char c = m_text[m_at++];
            depth += c == '(' ? 1 : (c == ')' ? -1 : 0);
            if (depth == 0) {
                return true;
            }
        }
        return false;
    }

private:
    void skipBlanks() {
        while (m_at < m_text.size() &&
               std::isspace(static_cast<unsigned char>(m_text[m_at])) != 0) {
            ++m_at;
        }
    }

    std::string_view m_text;
    std::size_t m_at;
};

void scanRegistrations(std::string_view text, SourceScan &scan) {
    constexpr std::string_view kMacro = "NORI_REGISTER_CLASS";
    for (std::size_t at = text.find(kMacro); at != std::string_view::npos;
         at = text.find(kMacro, at + 1)) {
        Cursor cursor(text, at + kMacro.size());
        if (!cursor.symbol('(')) {
            continue;
        }
        const std::string name = cursor.word();
        if (cursor.symbol(',') && cursor.symbol('"')) {
            scan.registeredTypes.insert(cursor.word());
            scan.definitions.insert(name);
        }
    }
}

/// `Class::method(...)` that is followed by a body.
void scanMethods(std::string_view text, SourceScan &scan) {
    for (std::size_t at = text.find("::"); at != std::string_view::npos;
         at = text.find("::", at + 2)) {
        std::size_t begin = at;
        while (begin > 0 && isWordCharacter(text[begin - 1])) {
            --begin;
        }
        Cursor cursor(text, at + 2);
        const std::string method = cursor.word();
        if (begin == at || method.empty() || !cursor.symbol('(') || !cursor.closeBracket()) {
            continue;
        }
        const std::string specifier = cursor.word(); // const, or nothing
        if ((specifier.empty() || specifier == "const") && cursor.symbol('{')) {
            scan.definitions.insert(std::string(text.substr(begin, at - begin)) + "::" + method);
        }
    }
}

bool intersects(const std::set<std::string> &a, const std::set<std::string> &b) {
    return std::any_of(a.begin(), a.end(),
                       [&](const std::string &each) { return b.count(each) > 0; });
}

} // namespace

bool SourceScan::sharesWith(const SourceScan &other) const {
    return intersects(registeredTypes, other.registeredTypes) ||
           intersects(definitions, other.definitions);
}

SourceScan scanSource(std::string_view text) {
    const std::string code = withoutComments(text);
    SourceScan scan;
    scanRegistrations(code, scan);
    scanMethods(code, scan);
    return scan;
}

} // namespace grader
