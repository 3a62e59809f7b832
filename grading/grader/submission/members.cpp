// SPDX-License-Identifier: MIT
#include <grader/submission/members.h>
#include <grader/submission/names.h>

#include <algorithm>
#include <array>
#include <set>

namespace grader {

namespace {

constexpr std::size_t kMaxNipDigits = 10;
constexpr int kLinesAfterWord = 4; ///< a list of authors follows its heading

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

bool isAlphanumeric(char c) {
    return isDigit(c) || (c >= 'a' && c <= 'z');
}

/// The digits at `at`, and moves behind them.
std::string takeDigits(std::string_view text, std::size_t &at) {
    std::string digits;
    while (at < text.size() && isDigit(text[at])) {
        digits += text[at++];
    }
    return digits;
}

/// `p2_1_2` at `at`, or no members.
NamedMembers parseAt(std::string_view text, std::size_t at) {
    NamedMembers result;
    const std::size_t begin = at++;
    const std::string number = takeDigits(text, at);
    if (number.empty() || number.size() > 2) {
        return {};
    }
    result.assignment = text.substr(begin, at - begin);
    while (at + 1 < text.size() && text[at] == '_' && isDigit(text[at + 1])) {
        std::size_t next = at + 1;
        const std::string nip = takeDigits(text, next);
        if (nip.size() > kMaxNipDigits || (next < text.size() && isAlphanumeric(text[next]))) {
            break;
        }
        result.members.push_back(nip);
        at = next;
    }
    if (result.members.empty()) {
        return {};
    }
    result.asAsked = begin == 0 && at == text.size() && result.members.size() <= 2;
    return result;
}

bool speaksOfAuthors(const std::string &line) {
    static constexpr std::array<const char *, 6> kWords{"nip",    "autor",       "author",
                                                        "alumno", "integrantes", "student"};
    return std::any_of(kWords.begin(), kWords.end(),
                       [&](const char *word) { return line.find(word) != std::string::npos; });
}

void collectNumbers(const std::string &line, const std::set<std::size_t> &lengths, bool anywhere,
                    std::set<std::string> &nips) {
    for (std::size_t at = 0; at < line.size();) {
        const std::size_t begin = at;
        const std::string digits = takeDigits(line, at);
        if (digits.empty()) {
            ++at;
            continue;
        }
        const bool ownWord = (begin == 0 || !isAlphanumeric(line[begin - 1])) &&
                             (at == line.size() || !isAlphanumeric(line[at]));
        const bool address = at < line.size() && line[at] == '@';
        if (lengths.count(digits.size()) > 0 && ownWord && (anywhere || address)) {
            nips.insert(digits);
        }
    }
}

} // namespace

NamedMembers parseMembers(std::string_view name) {
    const std::string text = lowerAscii(name);
    for (std::size_t at = text.find('p'); at != std::string::npos; at = text.find('p', at + 1)) {
        if (at > 0 && isAlphanumeric(text[at - 1])) {
            continue;
        }
        NamedMembers found = parseAt(text, at);
        if (!found.members.empty()) {
            return found;
        }
    }
    return {};
}

std::vector<std::string> findNips(std::string_view readme,
                                  const std::vector<std::string> &members) {
    std::set<std::size_t> lengths;
    for (const std::string &member : members) {
        if (member.size() >= 5) { // a shorter number is as well a year or a sample count
            lengths.insert(member.size());
        }
    }
    std::set<std::string> nips;
    int open = 0;
    for (std::size_t begin = 0; begin < readme.size();) {
        const std::size_t end = std::min(readme.find('\n', begin), readme.size());
        const std::string line = lowerAscii(readme.substr(begin, end - begin));
        open = speaksOfAuthors(line) ? 1 + kLinesAfterWord : std::max(0, open - 1);
        collectNumbers(line, lengths, open > 0, nips);
        begin = end + 1;
    }
    return {nips.begin(), nips.end()};
}

} // namespace grader
