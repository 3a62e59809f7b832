// SPDX-License-Identifier: MIT
#include <grader/submission/figure_name.h>
#include <grader/submission/names.h>

#include <algorithm>
#include <charconv>
#include <vector>

namespace grader {

namespace {

constexpr int kMostSamples = 1 << 24;

/// Runs of letters and runs of digits: what stands between them varies.
std::vector<std::string> wordsOf(const std::string &text) {
    enum class Kind { None, Letters, Digits } last = Kind::None;
    std::vector<std::string> words;
    for (const char c : text) {
        const bool isDigit = c >= '0' && c <= '9';
        const bool isLetter = (c >= 'a' && c <= 'z') || (c & 0x80) != 0;
        const Kind kind = isDigit ? Kind::Digits : isLetter ? Kind::Letters : Kind::None;
        if (kind != Kind::None) {
            if (kind != last)
                words.emplace_back();
            words.back() += c;
        }
        last = kind;
    }
    return words;
}

bool isUnit(const std::string &word) {
    return word == "spp" || word == "sample" || word == "samples";
}

int numberOf(const std::string &word) {
    int number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    const bool isWhole = error == std::errc{} && end == word.data() + word.size();
    return isWhole && number > 0 && number <= kMostSamples ? number : 0;
}

} // namespace

FigureName parseFigureName(std::string_view stem) {
    const std::string lower = lowerAscii(stem);
    std::vector<std::string> words = wordsOf(lower);
    FigureName name;
    const bool hasUnit = !words.empty() && isUnit(words.back());
    if (hasUnit)
        words.pop_back();
    if (!words.empty())
        name.samples = numberOf(words.back());
    const std::string number = name.samples > 0 ? words.back() : "";
    if (name.samples > 0)
        words.pop_back();
    for (const std::string &word : words)
        name.scene += (name.scene.empty() ? "" : "_") + word;
    name.asAsked = std::string(stem) == (number.empty() ? name.scene : name.scene + "_" + number);
    return name;
}

} // namespace grader
