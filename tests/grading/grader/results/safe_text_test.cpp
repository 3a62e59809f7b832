// SPDX-License-Identifier: MIT
#include <grader/results/safe_text.h>
#include <support/sample_result.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace grader {
namespace {

TEST(SafeLine, KeepsWhatPeopleWrite) {
    EXPECT_EQ(safeLine("Muñoz_á 田中 عرب 🎨 <b>"), "Muñoz_á 田中 عرب 🎨 <b>");
    EXPECT_EQ(safeLine(""), "");
}

TEST(SafeLine, DropsEscapesAndTurnsLineEndsIntoSpaces) {
    EXPECT_EQ(safeLine("\x1b[31mred\x1b[0m"), "[31mred[0m");
    EXPECT_EQ(safeLine("a\nb\tc\r"), "a b c");
    EXPECT_EQ(safeLine("\xc2\x9b"
                       "31m"),
              "31m");
    EXPECT_EQ(safeLine("\xe2\x80\xae"
                       "gnp.exe"),
              "gnp.exe");
    EXPECT_EQ(safeLine("a\xff"
                       "b"),
              "a\xef\xbf\xbd"
              "b");
    EXPECT_EQ(safeLines("a\nb"), "a\nb");
}

TEST(SafeLine, LeavesNoControlByteOfAnyHostileText) {
    for (const std::string &text : support::hostileStrings()) {
        const std::string safe = safeLine(text);
        EXPECT_TRUE(std::none_of(safe.begin(), safe.end(), [](char c) {
            return (c >= 0 && c < ' ') || c == '\x7f';
        })) << safe;
        EXPECT_EQ(safeLine(safe), safe);
    }
}

TEST(EscapeInvisible, WritesInvisibleCharactersAsJsonEscapes) {
    EXPECT_EQ(escapeInvisible("{\n \"ñ\": 1\n}"), "{\n \"ñ\": 1\n}");
    EXPECT_EQ(escapeInvisible("\x7f"), "\\u007f");
    EXPECT_EQ(escapeInvisible("\xc2\x9b"), "\\u009b");
    EXPECT_EQ(escapeInvisible("\xe2\x80\xae"), "\\u202e");
    EXPECT_EQ(escapeInvisible("\xf3\xa0\x81\x81"), "\\udb40\\udc41");
}

} // namespace
} // namespace grader
