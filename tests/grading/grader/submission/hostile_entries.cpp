// SPDX-License-Identifier: MIT
#include "hand_in.h"
#include "hostile_archives.h"
#include "raw_zip.h"

namespace grader::test {

namespace {

const Files kHonest = {{"src/mesh.cpp", "// mesh\n"}};

/// A tar whose first entries are of these types and lead to `target`.
std::string tarOf(const Files &files, unsigned type, const char *target) {
    int index = 0;
    Files all = files;
    all.insert(all.end(), kHonest.begin(), kHonest.end());
    return makeArchive(ARCHIVE_FORMAT_TAR_USTAR, all, [&](archive_entry *entry) {
        if (index++ != 0)
            return;
        archive_entry_set_filetype(entry, type);
        archive_entry_set_size(entry, 0);
        if (type == AE_IFLNK)
            archive_entry_copy_symlink(entry, target);
    });
}

std::string hardLinkTo(const char *target) {
    bool first = true;
    return makeArchive(ARCHIVE_FORMAT_TAR_USTAR, {{"src/warp.cpp", ""}, kHonest[0]},
                       [&](archive_entry *entry) {
                           if (std::exchange(first, false))
                               archive_entry_copy_hardlink(entry, target);
                       });
}

std::string zipWith(const ZipEntry &entry) {
    return rawZip({entry, {.name = "src/mesh.cpp", .bytes = "// mesh\n"}});
}

std::string twice(const std::string &first, const std::string &second,
                  const std::string &bytes = "// other\n") {
    return rawZip({{.name = first, .bytes = "// one\n"},
                   {.name = second, .bytes = bytes},
                   {.name = "src/mesh.cpp", .bytes = "// mesh\n"}});
}

} // namespace

std::vector<HostileArchive> hostileEntries() {
    static constexpr char kLink[] = "is a link";
    static constexpr char kSpecial[] = "is a device or another special file";
    return {
        {"LinkToRoot",
         [] {
             return tarOf({{"src/warp.cpp", ""}}, AE_IFLNK, "/etc/passwd");
         },
         nullptr, kLink, true},
        {"LinkToParent",
         [] {
             return tarOf({{"src/warp.cpp", ""}}, AE_IFLNK, "../../x");
         },
         nullptr, kLink, true},
        {"LinkToItself",
         [] {
             return tarOf({{"src/warp.cpp", ""}}, AE_IFLNK, "warp.cpp");
         },
         nullptr, kLink, true},
        {"FileThroughLink",
         [] {
             return tarOf({{"out", ""}, {"out/warp.cpp", "// hostile"}}, AE_IFLNK, "/tmp");
         },
         nullptr, kLink, true},
        {"FileOverLink",
         [] {
             return tarOf({{"a.txt", ""}, {"a.txt", "hostile"}}, AE_IFLNK, "/etc/passwd");
         },
         nullptr, kLink, true},
        {"HardLinkToRoot", [] { return hardLinkTo("/etc/passwd"); }, nullptr, kLink, true},
        {"HardLinkWithin", [] { return hardLinkTo("src/mesh.cpp"); }, nullptr, kLink, true},
        {"LinkInZip",
         [] {
             return zipWith({.name = "src/warp.cpp", .bytes = "/etc/passwd", .unixMode = 0120777});
         },
         nullptr, kLink, true},
        {"LinkIn7z",
         [] {
             bool first = true;
             return makeArchive(ARCHIVE_FORMAT_7ZIP, {{"src/warp.cpp", ""}, kHonest[0]},
                                [&](archive_entry *entry) {
                                    if (!std::exchange(first, false))
                                        return;
                                    archive_entry_set_filetype(entry, AE_IFLNK);
                                    archive_entry_copy_symlink(entry, "/etc/passwd");
                                });
         },
         nullptr, kLink, true},
        {"CharacterDevice",
         [] {
             return tarOf({{"src/warp.cpp", ""}}, AE_IFCHR, "");
         },
         nullptr, kSpecial, true},
        {"BlockDevice",
         [] {
             return tarOf({{"src/warp.cpp", ""}}, AE_IFBLK, "");
         },
         nullptr, kSpecial, true},
        {"NamedPipe",
         [] {
             return tarOf({{"src/warp.cpp", ""}}, AE_IFIFO, "");
         },
         nullptr, kSpecial, true},
        {"SocketInZip",
         [] { return zipWith({.name = "src/warp.cpp", .bytes = "x", .unixMode = 0140777}); },
         nullptr, kSpecial, true},
        {"SetuidFile",
         [] { return zipWith({.name = "notes.txt", .bytes = "x", .unixMode = 0104755}); }, nullptr,
         "", true},
        {"FolderNamedAsASource",
         [] {
             return tarOf({{"src/warp.cpp", ""}}, AE_IFDIR, "");
         },
         nullptr, "", true},
        {"Encrypted", [] { return zipWith({.name = "a.txt", .bytes = "x", .flags = 1}); }, nullptr,
         "is encrypted", true},
        {"AllEncrypted",
         [] { return rawZip({{.name = "src/mesh.cpp", .bytes = "x", .flags = 1}}); },
         "the archive is encrypted", "", false},
        {"EncryptedByAes",
         [] {
             return rawZip({{.name = "src/mesh.cpp",
                             .bytes = "x",
                             .method = 99,
                             .flags = 1,
                             .extra = std::string("\x01\x99\x07\0\x02\0AE\x03\0\0", 11)}});
         },
         "the archive is encrypted", "", false},
        {"SamePathTwice", [] { return twice("src/warp.cpp", "src/warp.cpp"); }, nullptr,
         "two different files", true},
        {"SameFileTwice", [] { return twice("a.txt", "a.txt", "// one\n"); }, nullptr, "", true},
        {"CaseCollision", [] { return twice("src/warp.cpp", "SRC/Warp.CPP"); }, nullptr,
         "the same path on Windows", true},
        {"UnicodeCollision",
         [] { return twice("figures/Mu\u00f1oz.png", "figures/Mun\u0303oz.png"); }, nullptr,
         "the same path on Windows", true},
        {"FileAndFolder", [] { return twice("src/warp.cpp", "src/warp.cpp/a.txt"); }, nullptr, "",
         true},
        {"Cp850Name", [] { return twice("figures/Mu\xa4oz.png", "a.txt"); }, nullptr, "", true},
        {"Latin1Name", [] { return twice("figures/Mu\xf1oz.png", "a.txt"); }, nullptr, "", true},
        {"MarkedUtf8ThatIsNone",
         [] { return zipWith({.name = "figures/\xf1\xff.png", .bytes = "x", .flags = 0x800}); },
         nullptr, "", true},
        {"OtherNameInTheDirectory",
         [] {
             return zipWith({.name = "../../warp.cpp", .bytes = "x", .centralName = "notes.txt"});
         },
         nullptr, "", true},
        {"HostileNameInTheDirectory",
         [] {
             return zipWith({.name = "notes.txt", .bytes = "x", .centralName = "../../warp.cpp"});
         },
         nullptr, "", true},
        {"NameInAnExtraField", // Info-ZIP's Unicode path, for another name
         [] {
             return zipWith({.name = "notes.txt",
                             .bytes = "x",
                             .extra = std::string("up\x10\0\x01\0\0\0\0../warp.cpp", 20)});
         },
         nullptr, "", true},
    };
}

} // namespace grader::test
