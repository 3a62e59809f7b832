// SPDX-License-Identifier: MIT
#include <sys/stat.h>

#include <chrono>

#include "hand_in.h"

namespace grader::test {
namespace {

const std::string kWarp = "// warp\n";

TEST(Archives, OfSeveralKindsAreRead) {
    for (const int format : {ARCHIVE_FORMAT_ZIP, ARCHIVE_FORMAT_TAR_PAX_RESTRICTED,
                             ARCHIVE_FORMAT_TAR_USTAR, ARCHIVE_FORMAT_7ZIP}) {
        const Submission submission = readBytes(makeArchive(format, {{"src/warp.cpp", kWarp}}));
        EXPECT_NE(submission.find(FileRole::Source, "warp.cpp"), nullptr) << format;
    }
}

TEST(Archives, ThatAreNoneAreErrors) {
    const auto error = [](const std::string &bytes) {
        return messageOf([&] { readBytes(bytes); });
    };
    EXPECT_NE(error("this is no archive, only a text").find("not an archive"), std::string::npos);
    EXPECT_NE(error("").find("0 bytes"), std::string::npos);
    EXPECT_NE(error("PK\x03\x04").find("not an archive"), std::string::npos);
    EXPECT_NE(messageOf([] { readSubmission("/nonexistent/p2_1_2.zip"); }).find("no such file"),
              std::string::npos);
    EXPECT_NE(messageOf([] { readSubmission("/dev/null"); }).find("neither a file nor a folder"),
              std::string::npos);
}

TEST(Archives, DoNotNameFilesOfThisMachine) {
    // libarchive reads mtree too, whose entries take their contents from the disk.
    const std::string mtree = "#mtree\n./warp.cpp type=file contents=/etc/passwd\n";
    EXPECT_NE(messageOf([&] { readBytes(mtree); }).find("not an archive"), std::string::npos);
}

TEST(HostileEntries, WithPathsThatLeadOutAreRefused) {
    const Submission submission = readZip({{"../../warp.cpp", kWarp},
                                           {"/etc/area.cpp", kWarp},
                                           {"C:/mesh.cpp", kWarp},
                                           {"..\\scene.cpp", kWarp},
                                           {std::string(300, 'x') + ".cpp", kWarp},
                                           {"src/environment.cpp", kWarp}});
    std::size_t sources = 0;
    for (const SubmittedFile &file : submission.files) {
        sources += file.role == FileRole::Source ? 1U : 0U;
    }
    EXPECT_EQ(sources, 1U);
    EXPECT_EQ(submission.files.size(), 6U);
    EXPECT_TRUE(hasNote(submission, Note::Level::Human, "leaves the archive"));
    EXPECT_TRUE(hasNote(submission, Note::Level::Human, "absolute path"));
    EXPECT_TRUE(hasNote(submission, Note::Level::Human, "over-long name"));
}

TEST(HostileEntries, ThatAreLinksOrDevicesAreRefused) {
    for (const int type : {AE_IFLNK, AE_IFCHR, AE_IFIFO}) {
        const std::string tar =
            makeArchive(ARCHIVE_FORMAT_TAR_USTAR, {{"area.cpp", ""}}, [&](archive_entry *entry) {
                archive_entry_set_filetype(entry, static_cast<unsigned>(type));
                if (type == AE_IFLNK) {
                    archive_entry_copy_symlink(entry, "/etc/passwd");
                }
            });
        EXPECT_EQ(roleOf(readBytes(tar), "area.cpp"), FileRole::Ignored) << type;
    }
    const std::string hard =
        makeArchive(ARCHIVE_FORMAT_TAR_USTAR, {{"area.cpp", ""}}, [](archive_entry *entry) {
            archive_entry_copy_hardlink(entry, "/etc/passwd");
        });
    EXPECT_TRUE(hasNote(readBytes(hard), Note::Level::Human, "'area.cpp' is a link"));
    const std::string zip =
        makeArchive(ARCHIVE_FORMAT_ZIP, {{"area.cpp", ""}}, [](archive_entry *entry) {
            archive_entry_set_filetype(entry, AE_IFLNK);
            archive_entry_copy_symlink(entry, "/etc/passwd");
        });
    EXPECT_EQ(roleOf(readBytes(zip), "area.cpp"), FileRole::Ignored);
}

TEST(HostileArchives, ThatAreBombsAreRefused) {
    const std::string zeros = makeZip({{"figures/a.exr", std::string(16U << 20U, '\0')}});
    EXPECT_LT(zeros.size(), 1U << 20U);
    const std::string error = messageOf([&] { readBytes(zeros); });
    EXPECT_NE(error.find("more than 200 times its size, at 'figures/a.exr'"), std::string::npos)
        << error;
    // In a folder that is left out, and in an archive within, it is one too.
    const Files hidden{{"build/a.o", std::string(16U << 20U, '\0')}};
    EXPECT_NE(messageOf([&] { readBytes(makeZip(hidden)); }).find("200 times"), std::string::npos);
    EXPECT_NE(messageOf([&] {
                  readZip({{"inner.zip", zeros}});
              }).find("200 times"),
              std::string::npos);
}

TEST(Archives, DecodeTheNamesOfFoldersThatAreLeftOut) {
    const Submission submission = readZip({{"src/warp.cpp", kWarp}, {"build_\xA4/a.o", "x"}});
    EXPECT_EQ(roleOf(submission, "build_\u00f1/"), FileRole::Ignored); // CP850
}

TEST(HostileArchives, WithMoreFilesThanAllowedAreRefusedAtOnce) {
    Files files;
    for (int i = 0; i < 50'000; ++i) {
        files.emplace_back("src/f" + std::to_string(i) + ".cpp", "");
    }
    const std::string zip = makeZip(files);
    const auto start = std::chrono::steady_clock::now();
    EXPECT_NE(messageOf([&] { readBytes(zip); }).find("more than 2000 files"), std::string::npos);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

TEST(Limits, HoldForRealBytes) {
    const Files files{{"src/warp.cpp", kWarp}, {"figures/a.exr", std::string(5000, 'a')}};
    ReadLimits small;
    small.fileBytes = 1000;
    const Submission submission = readBytes(makeZip(files), "p2_1_2.zip", small);
    EXPECT_EQ(roleOf(submission, "figures/a.exr"), FileRole::Ignored);
    EXPECT_NE(submission.find(FileRole::Source, "warp.cpp"), nullptr);
    EXPECT_TRUE(hasNote(submission, Note::Level::Human, "is larger than"));

    ReadLimits entries;
    entries.entries = 2;
    const Files built{{"build/a.o", ""}, {"build/b.o", ""}, {"build/c.o", ""}};
    EXPECT_NE(messageOf([&] {
                  readBytes(makeZip(built), "p2_1_2.zip", entries);
              }).find("more than 2 entries"),
              std::string::npos);
    ReadLimits total;
    total.totalBytes = 1000;
    EXPECT_NE(messageOf([&] { readBytes(makeZip(files), "p2_1_2.zip", total); }).find("unpacks"),
              std::string::npos);
    ReadLimits time;
    time.time = std::chrono::milliseconds(-1);
    EXPECT_NE(messageOf([&] { readBytes(makeZip(files), "p2_1_2.zip", time); }).find("takes more"),
              std::string::npos);
}

TEST(DamagedArchives, GiveWhatCanBeRead) {
    // Random, so that nothing is compressed away.
    std::string noise;
    for (unsigned x = 1; noise.size() < 20'000; x = x * 1664525U + 1013904223U) {
        noise += static_cast<char>(x >> 24U);
    }
    const std::string zip = makeZip({{"src/warp.cpp", kWarp}, {"figures/a.png", noise}});
    const Submission cut = readBytes(zip.substr(0, zip.size() / 2));
    EXPECT_NE(cut.find(FileRole::Source, "warp.cpp"), nullptr);
    EXPECT_TRUE(hasNote(cut, Note::Level::Human, "damaged")) << allNotes(cut);

    std::string flipped = zip;
    flipped[zip.size() / 2] = static_cast<char>(~flipped[zip.size() / 2]);
    const Submission wrong = readBytes(flipped);
    EXPECT_NE(wrong.find(FileRole::Source, "warp.cpp"), nullptr);
    EXPECT_EQ(roleOf(wrong, "figures/a.png"), FileRole::Ignored) << allNotes(wrong);
}

TEST(DamagedArchives, NeverCrashWhereverTheyAreCutOrChanged) {
    for (const int format : {ARCHIVE_FORMAT_ZIP, ARCHIVE_FORMAT_7ZIP, ARCHIVE_FORMAT_TAR_USTAR}) {
        const std::string good =
            makeArchive(format, {{"src/warp.cpp", kWarp}, {"README.txt", "hola"}});
        const std::size_t step = std::max<std::size_t>(1, good.size() / 40);
        for (std::size_t at = 0; at < good.size(); at += step) {
            std::string changed = good;
            changed[at] = static_cast<char>(~changed[at]);
            messageOf([&] { readBytes(good.substr(0, at)); });
            messageOf([&] { readBytes(changed); });
        }
    }
}

/// Sets bit `bit` of the flags of every local header and central entry.
std::string withZipFlag(std::string zip, unsigned char bit) {
    for (std::size_t i = 0; i + 10 < zip.size(); ++i) {
        const std::string_view mark = std::string_view(zip).substr(i, 4);
        const std::size_t at = mark == "PK\x03\x04" ? 6 : (mark == "PK\x01\x02" ? 8 : 0);
        if (at > 0) {
            zip[i + at] = static_cast<char>(static_cast<unsigned char>(zip[i + at]) | bit);
        }
    }
    return zip;
}

TEST(EncryptedArchives, AreNamedAsSuch) {
    const std::string zip = withZipFlag(makeZip({{"warp.cpp", kWarp}}), 1);
    const std::string error = messageOf([&] { readBytes(zip); });
    EXPECT_NE(error.find("encrypted"), std::string::npos) << error;

    const Submission partly = readZip({{"area.cpp", kWarp}, {"inner.zip", zip}});
    EXPECT_NE(partly.find(FileRole::Source, "area.cpp"), nullptr);
    EXPECT_TRUE(hasNote(partly, Note::Level::Human, "encrypted"));
}

TEST(Names, InEachEncodingAreRead) {
    for (const char *raw : {"figures/Mu\xA4oz.png", "figures/Mu\xF1oz.png",
                            "figures\\Mu\xC3\xB1oz.png", "figures/Mun\xCC\x83oz.png"}) {
        // ustar takes the bytes of a name as they are
        const std::string tar =
            makeArchive(ARCHIVE_FORMAT_TAR_USTAR, {{raw, "x"}, {"warp.cpp", kWarp}});
        EXPECT_EQ(roleOf(readBytes(tar), "figures/Muñoz.png"), FileRole::Figure) << raw;
    }
}

TEST(Duplicates, OfAPathNeedAPersonWhenTheyDiffer) {
    const Submission differ = readZip({{"warp.cpp", kWarp}, {"warp.cpp", "// other"}});
    EXPECT_TRUE(hasNote(differ, Note::Level::Human, "two different files")) << allNotes(differ);
    const Submission folded = readZip({{"src/warp.cpp", kWarp}, {"SRC/WARP.cpp", "// other"}});
    EXPECT_TRUE(hasNote(folded, Note::Level::Human, "the same path on Windows"));
}

TEST(Folders, AreReadWithoutFollowingLinks) {
    const TemporaryFolder folder;
    folder.write("p2_111111_222222/src/warp.cpp", kWarp);
    folder.write("p2_111111_222222/build/big.o", "x");
    const auto root = folder.path() / "p2_111111_222222";
    std::filesystem::create_symlink("/etc/passwd", root / "area.cpp");
    std::filesystem::create_directory_symlink("/etc", root / "etc");
    ASSERT_EQ(mkfifo((root / "mesh.cpp").c_str(), 0600), 0);
    const Submission submission = readSubmission(root / "");
    EXPECT_EQ(submission.name, "p2_111111_222222");
    EXPECT_EQ(submission.members.size(), 2U);
    EXPECT_NE(submission.find(FileRole::Source, "warp.cpp"), nullptr);
    EXPECT_EQ(roleOf(submission, "area.cpp"), FileRole::Ignored);
    EXPECT_EQ(roleOf(submission, "etc"), FileRole::Ignored);
    EXPECT_EQ(roleOf(submission, "mesh.cpp"), FileRole::Ignored);
    EXPECT_EQ(roleOf(submission, "build/"), FileRole::Ignored);
}

TEST(Folders, GiveTheSameAsTheirZip) {
    const TemporaryFolder folder;
    folder.write("p2_1_2/src/warp.cpp", kWarp);
    folder.write("p2_1_2/README.txt", "hola");
    const Submission fromFolder = readSubmission(folder.path() / "p2_1_2");
    const Submission fromZip =
        readZip({{"src/warp.cpp", kWarp}, {"README.txt", "hola"}}, "p2_1_2.zip");
    EXPECT_EQ(fromFolder.digest, fromZip.digest);
    EXPECT_EQ(fromFolder.members, fromZip.members);
    const Submission other = readZip({{"src/warp.cpp", "// x"}, {"README.txt", "hola"}});
    EXPECT_NE(other.digest, fromZip.digest);
}

} // namespace
} // namespace grader::test
