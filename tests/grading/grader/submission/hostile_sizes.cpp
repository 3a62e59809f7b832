// SPDX-License-Identifier: MIT
#include "hand_in.h"
#include "hostile_archives.h"
#include "raw_zip.h"

namespace grader::test {

namespace {

const std::pair<std::string, std::string> kHonest{"src/mesh.cpp", "// mesh\n"};

std::string zeros(std::size_t mebibytes) {
    return std::string(mebibytes << 20U, '\0');
}

/// A tar behind a filter.
std::string packedTar(const Files &files, int (*addFilter)(archive *)) {
    std::string bytes(std::size_t{1} << 20U, '\0');
    std::size_t used = 0;
    archive *writer = archive_write_new();
    archive_write_set_format_ustar(writer);
    addFilter(writer);
    archive_write_open_memory(writer, bytes.data(), bytes.size(), &used);
    for (const auto &[name, content] : files) {
        archive_entry *entry = archive_entry_new();
        archive_entry_copy_pathname(entry, name.c_str());
        archive_entry_set_filetype(entry, AE_IFREG);
        archive_entry_set_size(entry, static_cast<la_int64_t>(content.size()));
        archive_write_header(writer, entry);
        archive_write_data(writer, content.data(), content.size());
        archive_entry_free(entry);
    }
    archive_write_close(writer);
    archive_write_free(writer);
    bytes.resize(used);
    return bytes;
}

std::string packedZeros(int (*addFilter)(archive *)) {
    return packedTar({kHonest, {"figures/a.exr", zeros(32)}}, addFilter);
}

/// One file of 8 GiB that is a hole but for one byte, as GNU tar writes it.
std::string sparseTar() {
    std::string header(512, '\0');
    const auto put = [&](std::size_t at, const std::string &text) {
        header.replace(at, text.size(), text);
    };
    const std::string eightGiB = "77777777777";
    put(0, "figures/a.exr");
    put(100, "0000644");
    put(124, "00000000001");
    put(148, "        ");
    put(156, "S");
    put(257, "ustar  ");
    put(386, "77777777776"); // its last byte is there
    put(398, "00000000001");
    put(483, eightGiB);
    unsigned sum = 0;
    for (const char c : header)
        sum += static_cast<unsigned char>(c);
    std::string octal(6, '0');
    for (std::size_t i = 6; i-- > 0; sum /= 8)
        octal[i] = static_cast<char>('0' + sum % 8);
    put(148, octal + '\0');
    return header + std::string(1536, '\0');
}

/// Archives in archives around a source.
std::string nested(int depth) {
    std::string bytes = makeZip({{"src/warp.cpp", "// warp\n"}});
    for (int i = 0; i < depth; ++i)
        bytes = makeZip({{"inner.zip", bytes}});
    return bytes;
}

std::string many(int count, const std::string &folder) {
    std::vector<ZipEntry> entries{{.name = kHonest.first, .bytes = kHonest.second}};
    for (int i = 0; i < count; ++i)
        entries.push_back({.name = folder + std::to_string(i) + ".txt", .bytes = ""});
    return rawZip(entries);
}

/// Entries that all show the same bytes of the file, to unpack to far more than it holds.
std::string overlapping(int count) {
    std::vector<ZipEntry> entries{{.name = kHonest.first, .bytes = kHonest.second},
                                  {.name = "figures/0.exr", .bytes = std::string(100'000, 'x')}};
    const std::int64_t crc = crcOf(entries[1].bytes);
    for (int i = 1; i < count; ++i) {
        ZipEntry same{.crc = crc};
        same.name = entries[1].name;
        same.bytes = entries[1].bytes;
        same.centralName = "figures/" + std::to_string(i) + ".exr";
        same.localOf = 1;
        entries.push_back(same);
    }
    return rawZip(entries);
}

} // namespace

std::vector<HostileArchive> hostileSizes() {
    static constexpr char kRatio[] = "unpacks to more than 200 times its size, at 'figures/a.exr'";
    return {
        {"Bomb",
         [] {
             return makeZip({kHonest, {"figures/a.exr", zeros(16)}});
         },
         kRatio, "", false},
        {"BombInABuildFolder",
         [] {
             return makeZip({kHonest, {"build/a.o", zeros(16)}});
         },
         "200 times its size, at 'build/a.o'", "", false},
        {"BombOfManyFiles",
         [] {
             Files files;
             for (int i = 0; i < 40; ++i)
                 files.emplace_back("figures/" + std::to_string(i) + ".exr", zeros(1));
             return makeZip(files);
         },
         "unpacks to more than 200 times its size", "", false},
        {"BombWithin",
         [] {
             return makeZip({kHonest, {"inner.zip", makeZip({{"figures/a.exr", zeros(16)}})}});
         },
         "unpacks to more than 200 times its size", "", false},
        {"BombIn7z",
         [] {
             return makeArchive(ARCHIVE_FORMAT_7ZIP, {kHonest, {"figures/a.exr", zeros(16)}});
         },
         kRatio, "", false},
        {"BombInGzip", [] { return packedZeros(archive_write_add_filter_gzip); }, kRatio, "",
         false},
        {"BombInBzip2", [] { return packedZeros(archive_write_add_filter_bzip2); }, kRatio, "",
         false},
        {"BombInXz", [] { return packedZeros(archive_write_add_filter_xz); }, kRatio, "", false},
        {"BombInZstd", [] { return packedZeros(archive_write_add_filter_zstd); }, kRatio, "",
         false},
        {"BombOfTarHeaders", // nothing but entries, packed by 100 to 1
         [] {
             Files files;
             for (int i = 0; i < 41'000; ++i)
                 files.emplace_back("build/a", "");
             return packedTar(files, archive_write_add_filter_gzip);
         },
         "has more than 40000 entries", "", false},
        {"TwoWithin", [] { return nested(2); }, nullptr, "An archive in it was opened", false},
        {"FourWithin", [] { return nested(4); }, nullptr, "is more than 2 archives deep", false},
        {"HundredWithin", [] { return nested(100); }, nullptr, "is more than 2 archives deep",
         false},
        {"FiftyThousandFiles", [] { return many(50'000, "src/"); }, "has more than 2000 files", "",
         false},
        {"FiftyThousandInABuildFolder", [] { return many(50'000, "build/"); },
         "has more than 40000 entries", "", false},
        {"FilesSpreadOverArchives",
         [] {
             Files files{kHonest};
             for (int i = 0; i < 5; ++i)
                 files.emplace_back("f" + std::to_string(i) + ".zip", many(600, "a/"));
             return makeZip(files);
         },
         "has more than 2000 files", "", false},
        {"LargeFile",
         [] {
             return makeArchive(ARCHIVE_FORMAT_TAR_USTAR, {kHonest, {"figures/a.exr", zeros(65)}});
         },
         nullptr, "is larger than 64 MiB", true},
        // One header in the file is one entry, however many point to it.
        {"Overlapping", [] { return overlapping(1500); }, nullptr, "figures/", true},
        {"SparseTar", sparseTar, "unpacks to more than 200 times its size", "", false},
        {"ManyEmptyArchives",
         [] {
             Files files{kHonest};
             for (int i = 0; i < 1500; ++i)
                 files.emplace_back("a" + std::to_string(i) + ".zip", rawZip({}));
             return makeZip(files);
         },
         nullptr, "", true},
    };
}

} // namespace grader::test
