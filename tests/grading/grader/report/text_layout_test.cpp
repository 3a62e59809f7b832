// SPDX-License-Identifier: MIT
#include <grader/report/text_layout.h>

#include <gtest/gtest.h>

namespace grader {
namespace {

using Lines = std::vector<std::string>;

TEST(DisplayWidth, CountsColumnsAndNotBytes) {
    EXPECT_EQ(displayWidth(""), 0u);
    EXPECT_EQ(displayWidth("abc"), 3u);
    EXPECT_EQ(displayWidth("Muñoz_á"), 7u);
    EXPECT_EQ(displayWidth("n\xcc\x83"), 1u); // n and a combining tilde
    EXPECT_EQ(displayWidth("田中"), 4u);
    EXPECT_EQ(displayWidth("\xff"), 1u);
}

TEST(Pad, FillsUpToAWidth) {
    EXPECT_EQ(padRight("ñ", 3), "ñ  ");
    EXPECT_EQ(padLeft("ñ", 3), "  ñ");
    EXPECT_EQ(padRight("long", 3), "long");
}

TEST(WrapText, BreaksAtSpaces) {
    EXPECT_EQ(wrapText("one two three", 7), (Lines{"one two", "three"}));
    EXPECT_EQ(wrapText("one two three", 0), (Lines{"one two three"}));
    EXPECT_EQ(wrapText("ñ ñ ñ", 3), (Lines{"ñ ñ", "ñ"}));
    EXPECT_EQ(wrapText("", 5), (Lines{""}));
}

TEST(WrapText, CutsAWordThatDoesNotFit) {
    EXPECT_EQ(wrapText("abcdefgh", 3), (Lines{"abc", "def", "gh"}));
    EXPECT_EQ(wrapText("a bcdef", 3), (Lines{"a", "bcd", "ef"}));
    EXPECT_EQ(wrapText("田中田", 4), (Lines{"田中", "田"}));
    EXPECT_EQ(wrapText("田", 1), (Lines{"田"}));
    EXPECT_EQ(wrapText("\xff\xff\xff", 2).size(), 2u);
}

} // namespace
} // namespace grader
