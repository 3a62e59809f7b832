// SPDX-License-Identifier: MIT
#include "hand_in.h"
#include "hostile_archives.h"
#include "raw_zip.h"

namespace grader::test {

namespace {

/// An attacker's file beside an honest one.
std::string zipWith(const std::string &path) {
    return rawZip(
        {{.name = path, .bytes = "// hostile\n"}, {.name = "src/mesh.cpp", .bytes = "// mesh\n"}});
}

std::string tarWith(const std::string &path) {
    return makeArchive(ARCHIVE_FORMAT_TAR_PAX_RESTRICTED,
                       {{path, "// hostile\n"}, {"src/mesh.cpp", "// mesh\n"}});
}

} // namespace

std::vector<HostileArchive> hostilePaths() {
    using namespace std::string_literals;
    static constexpr char kLeaves[] = "has a path that leaves the archive";
    static constexpr char kAbsolute[] = "has an absolute path";
    return {
        {"Parent", [] { return zipWith("../warp.cpp"); }, nullptr, kLeaves, true},
        {"ManyParents", [] { return zipWith("../../../../etc/warp.cpp"); }, nullptr, kLeaves, true},
        {"ParentInside", [] { return zipWith("src/../../warp.cpp"); }, nullptr, kLeaves, true},
        {"ParentAtEnd", [] { return zipWith("src/.."); }, nullptr, kLeaves, true},
        {"ParentAfterDot", [] { return zipWith("./../warp.cpp"); }, nullptr, kLeaves, true},
        {"ParentInTar", [] { return tarWith("../../warp.cpp"); }, nullptr, kLeaves, true},
        {"ParentOfWindows", [] { return zipWith("..\\..\\warp.cpp"); }, nullptr, kLeaves, true},
        {"ParentMixed", [] { return zipWith("src\\../..\\warp.cpp"); }, nullptr, kLeaves, true},
        {"Root", [] { return zipWith("/etc/warp.cpp"); }, nullptr, kAbsolute, true},
        {"RootInTar", [] { return tarWith("/etc/warp.cpp"); }, nullptr, kAbsolute, true},
        {"TwoSlashes", [] { return zipWith("//host/share/warp.cpp"); }, nullptr, kAbsolute, true},
        {"Share", [] { return zipWith("\\\\host\\share\\warp.cpp"); }, nullptr, kAbsolute, true},
        {"Drive", [] { return zipWith("C:\\warp.cpp"); }, nullptr, kAbsolute, true},
        {"DriveRelative", [] { return zipWith("c:warp.cpp"); }, nullptr, kAbsolute, true},
        {"NoName", [] { return zipWith(""); }, nullptr, "has no usable name", true},
        {"LongName", [] { return zipWith(std::string(300, 'x') + ".cpp"); }, nullptr,
         "has an over-long name", true},
        {"LongPath",
         [] {
             std::string path;
             for (int i = 0; i < 300; ++i)
                 path += "folder/";
             return zipWith(path + "warp.cpp");
         },
         nullptr, "has an over-long path", true},
        {"DeepPath",
         [] {
             std::string path;
             for (int i = 0; i < 400; ++i)
                 path += "a/";
             return zipWith(path + "notes.txt");
         },
         nullptr, "", true},
        // A name ends where C says it does: what follows is not part of it.
        {"NulInName", [] { return zipWith("notes.txt\0.cpp"s); }, nullptr, "", true},
        {"OverlongUtf8", [] { return zipWith("\xc0\xae\xc0\xae/warp.cpp"); }, nullptr, "", true},
        {"EncodedParent", [] { return zipWith("%2e%2e/notes.txt"); }, nullptr, "", true},
        {"FullwidthParent", [] { return zipWith("．．/notes.txt"); }, nullptr, "", true},
        {"LineEnd", [] { return zipWith("a\nPASSED\n.txt"); }, nullptr, "", true},
        {"TerminalEscape", [] { return zipWith("\x1b[2J\x1b[31m.txt"); }, nullptr, "", true},
        {"WrittenBackwards", [] { return zipWith("\u202etxt.exe"); }, nullptr, "", true},
        {"Markup", [] { return zipWith("<script>alert(1)</script>.txt"); }, nullptr, "", true},
        {"Formula", [] { return zipWith("=cmd|'/c calc'!A0"); }, nullptr, "", true},
        {"ReservedName", [] { return zipWith("src/CON.cpp"); }, nullptr, "", true},
        {"OtherStream", [] { return zipWith("src/warp.cpp:stream"); }, nullptr, "", true},
        {"TrailingDot", [] { return zipWith("src/warp.cpp."); }, nullptr, "", true},
        {"Option", [] { return zipWith("-o/etc/passwd"); }, nullptr, "", true},
        {"ResponseFile", [] { return zipWith("src/@args.cpp"); }, nullptr, "", true},
        {"ShellCommand", [] { return zipWith("src/$(touch x);`id`.cpp"); }, nullptr, "", true},
    };
}

} // namespace grader::test
