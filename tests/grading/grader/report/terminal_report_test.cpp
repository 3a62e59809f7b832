// SPDX-License-Identifier: MIT
#include <grader/report/terminal_report.h>
#include <grader/report/text_layout.h>
#include <support/sample_result.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

namespace grader {
namespace {

std::string golden(const std::string &name) {
    std::ifstream file(std::string(NORI_SOURCE_DIR) + "/tests/golden/" + name);
    return {std::istreambuf_iterator<char>(file), {}};
}

TEST(TerminalReport, LooksAsAgreed) {
    EXPECT_EQ(terminalReport(support::sampleResult(), {}), golden("terminal_report.txt"));
    EXPECT_EQ(terminalReport(support::sampleResult(),
                             {.width = 78, .colour = false, .unicodeSigns = true}),
              golden("terminal_report_78.txt"));
}

TEST(TerminalReport, HintsAsFarAsStaffAllowInTheLanguageThatIsAskedFor) {
    SubmissionResult result = support::sampleResult();
    result.items[0].diagnoses = {{"disk.missing_sqrt", 1}, {"disk.square", 0.6}};
    const Diagnosis &diagnosis = *findDiagnosis("disk.missing_sqrt");
    const std::string english = terminalReport(result, {});
    EXPECT_NE(english.find("hint: " + result.items[0].id + ": " +
                           diagnosis.in(Language::English).hints[0]),
              std::string::npos)
        << english;
    EXPECT_EQ(english.find(diagnosis.in(Language::English).hints[1]), std::string::npos);
    TerminalStyle style;
    style.language = Language::Spanish;
    result.hintSteps = 2;
    const std::string spanish = terminalReport(result, style);
    EXPECT_NE(spanish.find(diagnosis.in(Language::Spanish).sentence), std::string::npos);
    EXPECT_NE(spanish.find(diagnosis.in(Language::Spanish).hints[1]), std::string::npos);
    result.hintSteps = 0;
    EXPECT_EQ(terminalReport(result, {}).find("hint:"), std::string::npos);
}

TEST(TerminalReport, GivesNoPointsForACheck) {
    SubmissionResult result = support::sampleResult();
    result.marked = false;
    const std::string text = terminalReport(result, {});
    EXPECT_EQ(text.find(" / "), std::string::npos);
    EXPECT_NE(text.find("1 of 4 items right"), std::string::npos);
}

TEST(TerminalReport, FindsTheCommonFolderBesideWhatWasIgnored) {
    SubmissionResult result = support::sampleResult();
    result.files = {{"__MACOSX/", "ignored", "added by macOS"},
                    {"p2/src/warp.cpp", "source", ""},
                    {"p2/src/old.cpp", "ignored", "a copy"},
                    {"p2/figures/a.png", "figure", ""}};
    const std::string text = terminalReport(result, {});
    EXPECT_NE(text.find("in: p2/\n"), std::string::npos) << text;
    EXPECT_NE(text.find("used: src/warp.cpp\n"), std::string::npos) << text;
    EXPECT_NE(text.find("ignored: __MACOSX/ (added by macOS), src/old.cpp (a copy)"),
              std::string::npos)
        << text;
}

TEST(TerminalReport, KeepsToTheWidthOfTheTerminal) {
    for (const std::size_t width : {40u, 60u, 80u, 120u}) {
        SubmissionResult result = support::sampleResult();
        result.items[0].reason = "田中 Muñoz " + std::string(300, 'x') + " y";
        std::istringstream lines(terminalReport(result, {.width = width}));
        for (std::string line; std::getline(lines, line);)
            EXPECT_LE(displayWidth(line), std::max<std::size_t>(width, 52)) << line;
    }
}

TEST(TerminalReport, UsesEscapesOnlyWhenColourIsAskedForAndEndsEachOne) {
    EXPECT_EQ(terminalReport(support::sampleResult(), {.width = 80}).find('\x1b'),
              std::string::npos);
    const std::string text = terminalReport(support::sampleResult(), {.width = 80, .colour = true});
    const auto escapes = std::count(text.begin(), text.end(), '\x1b');
    EXPECT_GT(escapes, 0);
    EXPECT_EQ(escapes % 2, 0);
}

TEST(TerminalReport, CannotBeDrivenByAHandIn) {
    for (const std::string &hostile : support::hostileStrings()) {
        const bool hasFolder = hostile.find('/') != std::string::npos;
        const std::string plain = terminalReport(support::resultWith(hasFolder ? "a/x" : "x"), {});
        const auto lines = std::count(plain.begin(), plain.end(), '\n');
        const std::string text = terminalReport(support::resultWith(hostile), {});
        EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), lines) << hostile;
        for (const char *part : {"\x1b", "\r", "\b", "\x07", "\x7f", "\xc2\x9b", "\xe2\x80\xae",
                                 "\xe2\x81\xa6", "\xe2\x80\xa8"})
            EXPECT_EQ(text.find(part), std::string::npos) << hostile;
    }
}

TEST(TerminalReport, NamesTheFolderThatAllFilesAreInOnce) {
    SubmissionResult result = support::sampleResult();
    result.files = {{"P2/src/warp.cpp", "source", ""}, {"P2/src/mesh.cpp", "source", ""}};
    EXPECT_NE(terminalReport(result, {}).find("  in: P2/src/\n  used: warp.cpp, mesh.cpp\n"),
              std::string::npos);
    result.files.push_back({"P2/srcs.h", "header", ""});
    EXPECT_NE(
        terminalReport(result, {}).find("in: P2/\n  used: src/warp.cpp, src/mesh.cpp, srcs.h"),
        std::string::npos);
    result.files.resize(1);
    EXPECT_NE(terminalReport(result, {}).find("in: P2/src/\n  used: warp.cpp\n"),
              std::string::npos);
}

TEST(TerminalReport, SaysWhatTheCapTook) {
    SubmissionResult result;
    result.marked = true;
    result.cap = 100;
    result.items.resize(2);
    result.items[0].points = 90;
    result.items[1].points = 10;
    result.total = 100;
    EXPECT_EQ(sumLine(result), "100 of 100");
    result.items[1].points = 27.3;
    EXPECT_EQ(sumLine(result), "100 of 100 (117.3 earned, the cap is 100)");
}

TEST(TerminalReport, SaysThatMarksAreNotFinal) {
    SubmissionResult result = support::sampleResult();
    result.items[0].checks[0].verdict = Verdict::Infra;
    EXPECT_NE(terminalReport(result, {}).find("not final: a part could not be tested"),
              std::string::npos);
    result = support::resultWith("x");
    EXPECT_NE(terminalReport(result, {}).find("not final: someone has to look"), std::string::npos);
    result.total = kNoNumber;
    EXPECT_EQ(sumLine(result), "not graded");
}

} // namespace
} // namespace grader
