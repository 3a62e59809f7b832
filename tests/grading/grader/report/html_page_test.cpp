// SPDX-License-Identifier: MIT
#include <grader/report/html.h>
#include <grader/report/html_page.h>
#include <support/sample_result.h>

#include <gtest/gtest.h>
#include <pugixml.hpp>

namespace grader {
namespace {

const Provenance kProvenance = {"0.1.0", "p2", "aa", "bb", "g++ 12"};

std::size_t count(const std::string &text, const std::string &part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

TEST(HtmlPage, HoldsTheFactsOfTheResult) {
    const std::string page = htmlPage(support::sampleResult(), kProvenance);
    for (const char *part :
         {"<html lang=\"en\">", "p2_123456_654321", "72.5 of 100", "Title of direct_ems",
          "2.5 / 20", "The mean radiance is 31 % low.", "0.31", "Divide by the probability.",
          "src/área.cpp", "src/main_old.cpp", "S3", "0000000000000000000000000000002a", "g++ 12"})
        EXPECT_NE(page.find(part), std::string::npos) << part;
}

TEST(HtmlPage, AllowsNothingButItsOwnStyleSheet) {
    const std::string page = htmlPage(support::sampleResult(), kProvenance);
    const std::size_t begin = page.find("<style>") + 7;
    const std::string style = page.substr(begin, page.find("</style>") - begin);
    EXPECT_NE(page.find("default-src 'none'; style-src '" + contentHash(style) + "'"),
              std::string::npos);
    for (const char *part : {"<script", "http://", "https://", "url(", " style=", " on"})
        EXPECT_EQ(page.substr(0, page.find("<main>")).find(part), std::string::npos) << part;
}

TEST(HtmlPage, TellsHintsInBothLanguagesUpToTheStepThatStaffAllow) {
    SubmissionResult result = support::sampleResult();
    result.items[0].diagnoses = {{"disk.missing_sqrt", 1}};
    const DiagnosisText &english = findDiagnosis("disk.missing_sqrt")->in(Language::English);
    const DiagnosisText &spanish = findDiagnosis("disk.missing_sqrt")->in(Language::Spanish);
    std::string page = htmlPage(result, kProvenance, Language::Spanish);
    for (const DiagnosisText *text : {&english, &spanish}) {
        EXPECT_NE(page.find(text->sentence), std::string::npos);
        EXPECT_NE(page.find(text->hints[0]), std::string::npos);
        EXPECT_EQ(page.find(text->hints[1]), std::string::npos);
    }
    EXPECT_NE(page.find("id=\"lang-es\" checked"), std::string::npos);
    EXPECT_EQ(page.find("id=\"lang-en\" checked"), std::string::npos);
    EXPECT_EQ(count(page, "<div"), count(page, "</div>"));
    result.hintSteps = 0;
    EXPECT_EQ(htmlPage(result, kProvenance).find(english.hints[0]), std::string::npos);
    result.hintSteps = 3;
    EXPECT_NE(htmlPage(result, kProvenance).find(spanish.hints[2]), std::string::npos);
}

TEST(ContentHash, MatchesAKnownDigest) {
    // printf '' | openssl dgst -sha256 -binary | base64
    EXPECT_EQ(contentHash(""), "sha256-47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU=");
}

TEST(HtmlPage, HasTheSameElementsWhateverAHandInSays) {
    // Any markup that got through would change the count of tags or make the page malformed.
    const std::string plain = htmlPage(support::resultWith("x"), kProvenance);
    for (const std::string &hostile : support::hostileStrings()) {
        const std::string page = htmlPage(support::resultWith(hostile), kProvenance);
        EXPECT_EQ(count(page, "<"), count(plain, "<")) << hostile;
        EXPECT_EQ(count(page, ">"), count(plain, ">")) << hostile;
        EXPECT_EQ(count(page, "\""), count(plain, "\"")) << hostile;
        for (const char *part : {"\x1b", "\x07", "\x7f", "\xc2\x9b", "\xe2\x80\xae"})
            EXPECT_EQ(page.find(part), std::string::npos) << hostile;
    }
}

TEST(HtmlPage, ShowsWhereThePointsOfAWrongWarpFall) {
    const std::string page = htmlPage(support::resultWithMap(), kProvenance);
    for (const char *part :
         {"Where the points of <code>Warp::squareToUniformTriangle</code> fall</h3>",
          "Map of the observed counts", "Map of the expected counts", "Map of the residuals",
          // 2048 points in a triangle of area 1/2: 4 in each whole cell
          "2048 independent points in 32×32 cells, 48 outside of the map",
          "2000 observed, 4.0 expected"})
        EXPECT_EQ(count(page, part), 1U) << part;
    EXPECT_EQ(htmlPage(support::sampleResult(), kProvenance).find("Map of"), std::string::npos);
}

TEST(HtmlPage, IsWellFormed) {
    std::string page = htmlPage(support::resultWithMap(), kProvenance);
    // As XML, void elements need an end and flags a value.
    for (const auto &[from, to] :
         {std::pair<std::string, std::string>{"initial-scale=1\">", "initial-scale=1\"/>"},
          {"charset=\"utf-8\">", "charset=\"utf-8\"/>"},
          {"form-action 'none'\">", "form-action 'none'\"/>"},
          {"<br>", "<br/>"},
          {" open>", " open=\"\">"}}) {
        for (std::size_t at = page.find(from); at != std::string::npos;
             at = page.find(from, at + to.size()))
            page.replace(at, from.size(), to);
    }
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_string(page.c_str());
    EXPECT_TRUE(parsed) << parsed.description() << " at " << page.substr(parsed.offset, 60);
}

TEST(PageName, IsPlainAsciiAndDiffersForTheSameName) {
    EXPECT_EQ(pageName("p2_123456", 0), "p2_123456.html");
    EXPECT_EQ(pageName("p2_123456", 1), "p2_123456-2.html");
    EXPECT_EQ(pageName("../../etc/passwd", 0), "etc-passwd.html");
    EXPECT_EQ(pageName("", 0), "submission.html");
    EXPECT_EQ(pageName("田中", 0), "submission.html");
    EXPECT_LE(pageName(std::string(500, 'x'), 0).size(), 100u);
    for (const std::string &hostile : support::hostileStrings()) {
        const std::string name = pageName(hostile, 0);
        EXPECT_EQ(name.find_first_not_of(
                      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_."),
                  std::string::npos);
        EXPECT_NE(name[0], '.');
        EXPECT_NE(name[0], '-');
    }
}

} // namespace
} // namespace grader
