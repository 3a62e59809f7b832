// SPDX-License-Identifier: MIT
#include <grader/submission/members.h>
#include <grader/submission/papers.h>

#include "hand_in.h"

namespace grader::test {
namespace {

TEST(Members, ComeFromTheNameThatTheHandoutAsksFor) {
    EXPECT_EQ(parseMembers("p2_111111_222222").members,
              (std::vector<std::string>{"111111", "222222"}));
    EXPECT_TRUE(parseMembers("p2_111111_222222").asAsked);
    EXPECT_EQ(parseMembers("p2_111111").members, std::vector<std::string>{"111111"});
    const NamedMembers moodle = parseMembers("Ana Ruiz_12_assignsubmission_file_P2_111111_222222");
    EXPECT_EQ(moodle.members.size(), 2U);
    EXPECT_FALSE(moodle.asAsked);
    EXPECT_EQ(parseMembers("p1_111111").assignment, "p1");
    for (const char *name : {"", "p2", "p2_NIP1_NIP2", "lab2", "final_111111", "p2_", "p2__1"}) {
        EXPECT_TRUE(parseMembers(name).members.empty()) << name;
    }
}

TEST(Members, ThatTheReadmeDeniesNeedAPerson) {
    const auto noteFor = [](const std::string &readme) {
        const Submission submission = readZip({{"README.txt", readme}});
        return hasNote(submission, Note::Level::Human, "README says");
    };
    EXPECT_TRUE(noteFor("Autores:\nAna 111111\nLuis 333333\n"));
    EXPECT_FALSE(noteFor("Autores:\nLuis 222222\nAna 111111\n"));
    EXPECT_FALSE(noteFor("We used 262144 samples."));
    EXPECT_FALSE(noteFor("No numbers at all"));
}

TEST(Members, ThatAFolderWithinDeniesNeedAPerson) {
    EXPECT_TRUE(hasNote(readZip({{"p2_333333/src/warp.cpp", "// w"}}), Note::Level::Human,
                        "a folder in it for 333333"));
    EXPECT_FALSE(hasNote(readZip({{"p2_222222_111111/src/warp.cpp", "// w"}}), Note::Level::Human,
                         "a folder in it"));
}

TEST(Readme, IsFoundUnderOtherNames) {
    for (const char *name : {"README.txt", "Readme.TXT", "readme", "README.md", "LEEME.txt",
                             "léeme.txt", "LEAME.txt", "README.txt.txt", "read_me.txt"}) {
        EXPECT_TRUE(isReadmeName(name)) << name;
    }
    EXPECT_FALSE(isReadmeName("readme.cpp"));
    const Submission none = readZip({{"warp.cpp", "// w"}});
    EXPECT_TRUE(hasNote(none, Note::Level::Odd, "no README"));
}

TEST(Readme, IsShownAsUtf8WhateverItWas) {
    EXPECT_EQ(readmeText("A\xF1o\r\n"), "Año\n");
    EXPECT_EQ(readmeText(std::string("\xFF\xFE\xF1\0!\0", 6)), "ñ!");
    EXPECT_EQ(readmeText("\xEF\xBB\xBF"
                         "hola"),
              "hola");
    EXPECT_LE(readmeText(std::string(200000, 'a')).size(), 65536U);
    EXPECT_EQ(readmeText(""), "");
}

TEST(Readme, MayLinkToTheFigures) {
    const Submission submission =
        readZip({{"README.txt", "Figures: https://drive.google.com/drive/folders/abc?x=1 and "
                                "references http://www.pbr-book.org/"}});
    EXPECT_TRUE(hasNote(submission, Note::Level::Info,
                        "not opened: https://drive.google.com/drive/folders/abc?x=1"));
    EXPECT_FALSE(hasNote(submission, Note::Level::Info, "pbr-book"));
}

TEST(Figures, AreLookedForAnywhere) {
    const Submission submission = readZip({{"warp.cpp", "// w"},
                                           {"UniformTriangle.PNG", "x"},
                                           {"figures/env/serapis_env_64.exr", "x"}});
    EXPECT_FALSE(hasNote(submission, Note::Level::Odd, "UniformTriangle.png"));
    EXPECT_FALSE(hasNote(submission, Note::Level::Odd, "serapis_env_<samples>.exr"));
    EXPECT_TRUE(hasNote(submission, Note::Level::Odd, "serapis_env_<samples>.png"));
}

TEST(Names, ThatAreNotAsAskedAreNoted) {
    EXPECT_TRUE(hasNote(readZip({{"warp.cpp", "// w"}}, "entrega.zip"), Note::Level::Human,
                        "not named p2_NIP1_NIP2"));
    EXPECT_TRUE(hasNote(readZip({{"warp.cpp", "// w"}}, "p1_111111.zip"), Note::Level::Human,
                        "assignment p1"));
}

} // namespace
} // namespace grader::test
