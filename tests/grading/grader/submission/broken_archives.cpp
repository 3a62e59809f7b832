// SPDX-License-Identifier: MIT
#include "hand_in.h"
#include "hostile_archives.h"
#include "raw_zip.h"

namespace grader::test {

namespace {

/// Incompressible, so that a place in it is a place in the archive.
std::string noise(std::size_t size) {
    std::string bytes;
    for (unsigned x = 1; bytes.size() < size; x = x * 1664525U + 1013904223U)
        bytes += static_cast<char>(x >> 24U);
    return bytes;
}

const Files kFiles = {{"src/mesh.cpp", "// mesh\n"}, {"figures/a.png", noise(20'000)}};

std::string half(std::string bytes) {
    bytes.resize(bytes.size() / 2);
    return bytes;
}

std::string changed(std::string bytes, std::size_t at) {
    bytes[at] = static_cast<char>(~bytes[at]);
    return bytes;
}

std::string of(int format) {
    return makeArchive(format, kFiles);
}

/// An honest file and one that its headers describe wrongly.
std::string zipWith(const ZipEntry &entry) {
    return rawZip({{.name = "src/mesh.cpp", .bytes = "// mesh\n"}, entry});
}

} // namespace

std::vector<HostileArchive> brokenArchives() {
    using namespace std::string_literals;
    static constexpr char kNone[] = "not an archive that can be read";
    static constexpr char kDamaged[] = "damaged";
    return {
        {"Empty", [] { return std::string(); }, "the file is empty (0 bytes)", "", false},
        {"ZipWithoutEntries", [] { return rawZip({}); }, nullptr, "The hand-in is empty", false},
        {"Text", [] { return "this is no archive"s; }, kNone, "", false},
        {"Page", [] { return "<!DOCTYPE html><html>Log in</html>"s; }, kNone, "", false},
        {"Noise", [] { return noise(100'000); }, kNone, "", false},
        {"Program", [] { return "\x7f"s + "ELF" + noise(5000); }, kNone, "", false},
        {"TwoLetters", [] { return "PK"s; }, kNone, "", false},
        {"OnlyAHeader", [] { return "PK\x03\x04"s; }, kNone, "", false},
        {"ListOfFiles", // libarchive's mtree takes contents from the disk
         [] { return "#mtree\n./warp.cpp type=file contents=/etc/passwd\n"s; }, kNone, "", false},
        {"Cpio", [] { return of(ARCHIVE_FORMAT_CPIO_SVR4_NOCRC); }, kNone, "", false},
        {"Ar", [] { return "!<arch>\n" + noise(5000); }, kNone, "", false},
        // 32 KiB of zeros are an empty tar.
        {"Iso",
         [] {
             return std::string(32768, '\0') +
                    "\x01"
                    "CD001\x01" +
                    noise(5000);
         },
         nullptr, "The hand-in is empty", false},
        {"GzipOfText", [] { return "\x1f\x8b\x08\0\0\0\0\0\0\x03\xcb\x48\xcd\xc9\xc9\x07\0"s; },
         kNone, "", false},
        {"HalfAZip", [] { return half(of(ARCHIVE_FORMAT_ZIP)); }, nullptr, kDamaged, true},
        {"HalfATar", [] { return half(of(ARCHIVE_FORMAT_TAR_USTAR)); }, nullptr, kDamaged, true},
        {"HalfA7z", [] { return half(of(ARCHIVE_FORMAT_7ZIP)); }, kNone, "", false},
        {"ChangedDataInZip", [] { return changed(of(ARCHIVE_FORMAT_ZIP), 10'000); }, nullptr,
         kDamaged, true},
        {"ChangedDataIn7z", [] { return changed(of(ARCHIVE_FORMAT_7ZIP), 10'000); }, kNone, "",
         false},
        {"ChangedTarHeader", [] { return changed(of(ARCHIVE_FORMAT_TAR_USTAR), 100); }, kNone, "",
         false},
        {"WrongSum", [] { return zipWith({.name = "a.txt", .bytes = "x", .crc = 1}); }, nullptr,
         kDamaged, true},
        {"ClaimsFourGigabytes",
         [] { return zipWith({.name = "a.txt", .bytes = "x", .size = 0xfffffffe}); }, nullptr,
         kDamaged, true},
        {"ClaimsTooMuch", [] { return zipWith({.name = "a.txt", .bytes = "x", .size = 5000}); },
         nullptr, kDamaged, true},
        {"ClaimsTooLittle",
         [] { return zipWith({.name = "a.txt", .bytes = "0123456789", .size = 3}); }, nullptr,
         kDamaged, true},
        {"ClaimsNothing", [] { return zipWith({.name = "a.txt", .bytes = "0123", .size = 0}); },
         nullptr, "", true},
        {"UnknownMethod", [] { return zipWith({.name = "a.txt", .bytes = "x", .method = 77}); },
         nullptr, kDamaged, true},
        {"DeflatedNoise",
         [] { return zipWith({.name = "a.txt", .bytes = noise(500), .method = 8}); }, nullptr,
         kDamaged, true},
        {"HugeZip64Sizes",
         [] {
             return zipWith({.name = "a.txt",
                             .bytes = "x",
                             .size = 0xffffffff,
                             .extra = "\x01\0\x10\0\xff\xff\xff\xff\xff\xff\xff\x7f"
                                      "\xff\xff\xff\xff\xff\xff\xff\x7f"s});
         },
         nullptr, kDamaged, true},
        {"CountsTooMany",
         [] { return rawZip({{.name = "src/mesh.cpp", .bytes = "// mesh\n"}}, 60'000); }, nullptr,
         "", true},
        {"CountsTooFew",
         [] {
             return rawZip(
                 {{.name = "src/mesh.cpp", .bytes = "// mesh\n"}, {.name = "a.txt", .bytes = "x"}},
                 1);
         },
         nullptr, "", true},
        {"CommentWithAnotherEnd",
         [] { return rawZip({{.name = "src/mesh.cpp", .bytes = "// mesh\n"}}, -1, rawZip({})); },
         nullptr, "", false},
        {"BytesBefore",
         [] {
             return "MZ" + noise(1000) + rawZip({{.name = "src/mesh.cpp", .bytes = "// mesh\n"}});
         },
         nullptr, "", true},
        {"BytesAfter",
         [] { return rawZip({{.name = "src/mesh.cpp", .bytes = "// mesh\n"}}) + noise(1000); },
         nullptr, "", true},
        {"TwoZipsInARow",
         [] {
             return rawZip({{.name = "a.txt", .bytes = "x"}}) +
                    rawZip({{.name = "src/mesh.cpp", .bytes = "// mesh\n"}});
         },
         nullptr, "", true},
        {"BrokenWithin",
         [] {
             return makeZip({kFiles[0], {"inner.zip", half(of(ARCHIVE_FORMAT_7ZIP))}});
         },
         nullptr, "not an archive that can be read", true},
        {"TextNamedAsAnArchive",
         [] {
             return makeZip({kFiles[0], {"inner.zip", "no archive"}});
         },
         nullptr, "not an archive that can be read", true},
    };
}

} // namespace grader::test
