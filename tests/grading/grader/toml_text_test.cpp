// SPDX-License-Identifier: MIT
#include <grader/toml_text.h>

#include <gtest/gtest.h>

namespace grader {
namespace {

TEST(TomlText, MayHoldEveryLetterInTextsAndComments) {
    for (const char *text :
         {"", "a = 1", "\xef\xbb\xbf# \u00e1\na = '\u00e1'", "# \u00e1 ' \" \u00e1",
          "a = \"\u00e1 # \u00e1\" # \u00e1", "a = '\u00e1 \" \\' # '\u00e1", "a = \"\\\" \u00e1\"",
          "a = \"\"\"\n\u00e1 \"\" \u00e1\n\"\"\"", "a = '''\u00e1\n'' \u00e1'''\nb = '\u3042'",
          "a = \"\"\"\u00e1\\\"\"\"\u00e1\"\"\"\"\"\nb = '''\u00e1'''''"})
        EXPECT_EQ(tomlFault(text), "") << text;
}

TEST(TomlText, MayNotHoldThemElsewhere) {
    const auto isFault = [](std::string_view text, std::string_view where) {
        return tomlFault(text).rfind(where, 0) == 0;
    };
    EXPECT_TRUE(isFault("latent_fracci\u00f3n = 1", "1:14: a letter"));
    EXPECT_TRUE(isFault("a = 1\n\u00e1 = 2", "2:1:"));
    EXPECT_TRUE(isFault("a = '\u00e1' \u00e1", "1:10:"));
    EXPECT_TRUE(isFault("a = \"\"\u00e1", "1:7:"));
    EXPECT_TRUE(isFault("a = '''\n''' \u3042", "2:5:"));
    EXPECT_TRUE(isFault("a = 1 \xff", "1:7:"));
    EXPECT_TRUE(isFault("\xef\xbb\xbf\xef\xbb\xbf", "1:4:"));
}

TEST(TomlText, EndsWhatHasNoEndWithItsLine) {
    EXPECT_NE(tomlFault("a = \"\n\u00e1"), "");
    EXPECT_NE(tomlFault("a = '\r\u00e1"), "");
    EXPECT_NE(tomlFault("# \xe2\x80\xa8\u00e1"), "");
    EXPECT_EQ(tomlFault("a = \"\u00e1\\"), "");
}

TEST(TomlText, MayNotFollowAMarkWithinANumber) {
    // toml++ looks ahead to the end of a number: no text opens there for it.
    for (const char *text :
         {"a = 91[-\"\u00e1_\"", "a =1\"\"\"sss\u00e1\"\"\"", "a = [+1='\u00e1']",
          "a = 1979-05-27 \"\u00e1\"", "a = 1979-05-27 07\"\u00e1\""})
        EXPECT_NE(tomlFault(text).find("in what begins like a number"), std::string::npos) << text;
    for (const char *text :
         {"1 = \"\u00e1\"", "a = 1 # \"\u00e1", "a = [1, '\u00e1']\nb = -2\nc = '\u00e1'",
          "a1 = \"\u00e1\"", "a = 1\"\"\"s\"\"\""})
        EXPECT_EQ(tomlFault(text), "") << text;
}

} // namespace
} // namespace grader
