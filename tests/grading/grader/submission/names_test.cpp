// SPDX-License-Identifier: MIT
#include <grader/submission/names.h>

#include <gtest/gtest.h>

namespace grader {
namespace {

TEST(DecodedNames, AreRightInEachCodePageOfAWindowsZip) {
    // "Muñoz_árbol_é.png" as the four systems write it; NFD as macOS does.
    const std::string right = "Muñoz_árbol_é.png";
    for (const char *raw : {"Mu\xA4oz_\xA0rbol_\x82.png",                   // CP850, CP437
                            "Mu\xF1oz_\xE1rbol_\xE9.png",                   // Latin-1, CP1252
                            "Mu\xC3\xB1oz_\xC3\xA1rbol_\xC3\xA9.png",       // UTF-8
                            "Mun\xCC\x83oz_a\xCC\x81rbol_e\xCC\x81.png"}) { // UTF-8, NFD
        EXPECT_EQ(decodeNames({raw}).front(), right);
    }
}

TEST(DecodedNames, AreReadInOneCodePageTogether) {
    // In CP850 0xB5 0xE0 are "ÁÓ"; alone, 0xE0 would as well be the "à" of Latin-1.
    const auto names = decodeNames({"\xB5RBOL.png", "LE\xE0N.png", "plain.png"});
    EXPECT_EQ(names, (std::vector<std::string>{"ÁRBOL.png", "LEÓN.png", "plain.png"}));
    EXPECT_EQ(decodeNames({"Andr\xE9s", "Jos\xE9"}), (std::vector<std::string>{"Andrés", "José"}));
}

TEST(DecodedNames, AreAlwaysUtf8) {
    std::string all;
    for (int byte = 1; byte < 256; ++byte) {
        all += static_cast<char>(byte);
    }
    EXPECT_TRUE(isUtf8(decodeNames({all}).front()));
    EXPECT_FALSE(isUtf8(all));
    EXPECT_TRUE(decodeNames({}).empty());
    EXPECT_EQ(decodeNames({""}).front(), "");
}

TEST(FoldedNames, AreEqualForTheSameFileOnWindows) {
    EXPECT_EQ(foldName("Árbol.PNG"), foldName("a\xCC\x81rbol.png"));
    EXPECT_NE(foldName("arbol"), foldName("árbol"));
}

TEST(PathFault, IsFoundInPathsThatLeadOut) {
    for (const char *path : {"../x", "a/../../x", "/etc/passwd", "C:/x", "c:x", "", ".."}) {
        EXPECT_NE(pathFault(path), "") << path;
    }
    EXPECT_NE(pathFault(std::string("a\0b", 3)), "");
    EXPECT_NE(pathFault(std::string(300, 'a')), "");
    EXPECT_NE(pathFault("a/" + std::string(300, 'a') + "/b"), "");
    for (const char *path : {"a", "a/b.cpp", "..a/b", "a/b..", "ñ/á"}) {
        EXPECT_EQ(pathFault(path), "") << path;
    }
}

TEST(ShortenedNames, EndAtACharacter) {
    EXPECT_EQ(shortened("ñññ", 3), "ñ…");
    EXPECT_EQ(shortened("abc", 3), "abc");
}

TEST(PathParts, HoldFoldersStemAndExtension) {
    const PathParts parts = splitPath("a/b/Warp.Old.CPP");
    EXPECT_EQ(parts.folders, (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(parts.stem, "Warp.Old");
    EXPECT_EQ(parts.extension, ".cpp");
    EXPECT_EQ(splitPath(".git").extension, "");
}

} // namespace
} // namespace grader
