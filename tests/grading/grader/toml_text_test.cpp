// SPDX-License-Identifier: MIT
#include <grader/error.h>
#include <grader/toml_text.h>

#include <gtest/gtest.h>

namespace grader {
namespace {

std::string valueOfA(std::string_view text) {
    return parseToml(text, "r.toml")["a"].value_or(std::string("none"));
}

std::string faultOf(std::string_view text) {
    try {
        parseToml(text, "r.toml");
    } catch (const GraderError &error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST(TomlText, KeepsEveryLetterOfTexts) {
    EXPECT_EQ(valueOfA("a = 'x'"), "x");
    EXPECT_EQ(valueOfA("\xef\xbb\xbf# \u00e1 ' \"\na = '\u00e1 \" \\ # \u3042'"),
              "\u00e1 \" \\ # \u3042");
    EXPECT_EQ(valueOfA(R"(a = "\u00e1 \" á # \\á" # á)"), "\u00e1 \" \u00e1 # \\\u00e1");
    EXPECT_EQ(valueOfA("a = \"\"\"\n\u0080\u07ff\u0800\ufeff\uff21\U0001f600\n\"\"\""),
              "\u0080\u07ff\u0800\ufeff\uff21\U0001f600\n");
    EXPECT_EQ(valueOfA("a = \"\"\"uno \\\n  \u00e1rbol\"\"\""), "uno \u00e1rbol");
    const toml::table nested = parseToml("[[b.c]]\nd = [{e = '\u00e1'}, ['\u00e9']]", "r.toml");
    EXPECT_EQ(nested["b"]["c"][0]["d"][0]["e"].value_or(""), std::string("\u00e1"));
    EXPECT_EQ(nested["b"]["c"][0]["d"][1][0].value_or(""), std::string("\u00e9"));
}

TEST(TomlText, RefusesThemElsewhere) {
    EXPECT_EQ(faultOf("b = 1\nlatent_fracci\u00f3n = 1").rfind("r.toml:2:14: ", 0), 0U);
    EXPECT_NE(faultOf("latent_fracci\u00f3n = 1").find("'\u00f3'"), std::string::npos);
    EXPECT_EQ(faultOf("[x]\n'\u00f3' = 1"),
              "r.toml:2:1: the key '\u00f3' has letters beyond ASCII");
    for (const char *text : {"a = '\u00e1' \u00e1", "a = \"\"\u00e1", "a = '''\n''' \u3042",
                             "\xef\xbb\xbf\xef\xbb\xbf", "a = \"\n\u00e1", "a = '\r\u00e1"})
        EXPECT_NE(faultOf(text), "") << text;
}

TEST(TomlText, RefusesWhatIsNoUtf8) {
    EXPECT_EQ(faultOf("b = 1\na = '\xff'"), "r.toml:2:6: is not UTF-8; save it in that encoding");
    EXPECT_NE(faultOf("# \xc3").find("not UTF-8"), std::string::npos);
}

TEST(TomlText, RefusesLettersForPrivateUseOfPlane16) {
    for (const char *text : {"a = '\U001000e1'", R"(a = "\U001000e1")"})
        EXPECT_EQ(faultOf(text).rfind("r.toml:1:6: a letter of plane 16", 0), 0U) << faultOf(text);
    EXPECT_EQ(valueOfA("a = '\U000fffff'"), "\U000fffff");
}

TEST(TomlText, RefusesThemWhereTomlLooksAhead) {
    for (const char *text : {"a = 91[-\"\u00e1_\"", "a =1\"\"\"sss\u00e1\"\"\"",
                             "a = [+1='\u00e1']", "a = 1979-05-27 \"\u00e1\"",
                             "a = 1979-05-27 07\"\u00e1\"", R"(a = """\á""")", R"(a = """\ á""")"})
        EXPECT_NE(faultOf(text), "") << text;
}

} // namespace grader
