// SPDX-License-Identifier: MIT
#include <grader/diagnosis/catalogue.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace grader {

namespace {

std::vector<std::string> linesOf(const DiagnosisText &text) {
    std::vector<std::string> lines = {text.sentence};
    lines.insert(lines.end(), text.hints.begin(), text.hints.end());
    return lines;
}

/// Names of code, which are not translated: what is followed by `(`, or holds `::` or `_`.
std::set<std::string> codeIn(const DiagnosisText &text) {
    std::set<std::string> names;
    for (const std::string &line : linesOf(text)) {
        std::string word;
        for (const char c : line + " ") {
            const bool part = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' ||
                              c == ':' || c == '.';
            if (part) {
                word += c;
                continue;
            }
            while (!word.empty() && (word.back() == ':' || word.back() == '.'))
                word.pop_back();
            if (word.find("::") != std::string::npos || word.find('_') != std::string::npos)
                names.insert(word);
            word.clear();
        }
    }
    return names;
}

} // namespace

TEST(Catalogue, has_every_id_once_and_in_lower_case) {
    std::set<std::string> ids;
    for (const Diagnosis &diagnosis : diagnosisCatalogue()) {
        EXPECT_TRUE(ids.insert(diagnosis.id).second) << diagnosis.id;
        EXPECT_EQ(diagnosis.id.find_first_not_of("abcdefghijklmnopqrstuvwxyz_."), std::string::npos)
            << diagnosis.id;
        EXPECT_EQ(findDiagnosis(diagnosis.id), &diagnosis);
    }
    EXPECT_GT(ids.size(), 100U);
    EXPECT_EQ(findDiagnosis("disk.square_circle"), nullptr);
}

TEST(Catalogue, tells_a_sentence_and_a_ladder_in_both_languages) {
    for (const Diagnosis &diagnosis : diagnosisCatalogue()) {
        for (const Language language : kLanguages) {
            const std::vector<std::string> lines = linesOf(diagnosis.in(language));
            for (const std::string &line : lines) {
                EXPECT_GT(line.size(), 10U) << diagnosis.id << ": " << line;
                EXPECT_NE(std::string(".?;").find(line.back()), std::string::npos)
                    << diagnosis.id << ": " << line;
                EXPECT_EQ(line.find_first_of("\n\t{}"), std::string::npos)
                    << diagnosis.id << ": no layout and no placeholders: " << line;
            }
            EXPECT_EQ(std::set<std::string>(lines.begin(), lines.end()).size(), lines.size())
                << diagnosis.id << ": a step says nothing new";
        }
        EXPECT_NE(diagnosis.in(Language::English).sentence,
                  diagnosis.in(Language::Spanish).sentence);
    }
}

TEST(Catalogue, names_the_same_code_in_both_languages) {
    for (const Diagnosis &diagnosis : diagnosisCatalogue())
        EXPECT_EQ(codeIn(diagnosis.in(Language::English)), codeIn(diagnosis.in(Language::Spanish)))
            << diagnosis.id;
}

TEST(Catalogue, asks_in_spanish_with_both_question_marks) {
    for (const Diagnosis &diagnosis : diagnosisCatalogue()) {
        for (const std::string &line : linesOf(diagnosis.in(Language::Spanish))) {
            const auto closing = std::count(line.begin(), line.end(), '?');
            std::ptrdiff_t opening = 0;
            for (std::size_t at = line.find("¿"); at != std::string::npos;
                 at = line.find("¿", at + 1))
                ++opening;
            EXPECT_EQ(opening, closing) << diagnosis.id << ": " << line;
        }
    }
}

} // namespace grader
