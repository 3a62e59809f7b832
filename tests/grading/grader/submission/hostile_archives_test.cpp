// SPDX-License-Identifier: MIT
//
// Every archive of the tables: what comes of it, within bounds of time and memory, and no file
// anywhere.
#include <grader/submission/names.h>

#include <chrono>
#include <set>

#include "hand_in.h"
#include "hostile_archives.h"

namespace grader::test {

void PrintTo(const HostileArchive &archive, std::ostream *stream) {
    *stream << archive.name;
}

namespace {

constexpr std::chrono::seconds kTime(10); ///< the reader's own limit is 30 s
constexpr long kMemory = 700L << 10U;     ///< [KiB]; what is kept may be 512 MiB

/// A figure of /proc/self/status [KiB].
long memoryOf(const std::string &key) {
    std::ifstream lines("/proc/self/status");
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind(key, 0) == 0)
            return std::atol(line.c_str() + key.size());
    }
    return 0;
}

/// Everything below the folders that an archive could be unpacked to.
std::set<std::string> filesBelow(const std::filesystem::path &folder) {
    std::set<std::string> files;
    for (const auto &entry : std::filesystem::recursive_directory_iterator(folder))
        files.insert(entry.path().string());
    return files;
}

class Hostile : public testing::TestWithParam<HostileArchive> {};

TEST_P(Hostile, ArchiveIsContained) {
    const HostileArchive &archive = GetParam();
    const TemporaryFolder outside;
    const auto inside = outside.write("a/b/p2_111111_222222.zip", archive.make());
    const auto before = filesBelow(outside.path());
    const auto workingFolder = std::filesystem::current_path();
    std::filesystem::current_path(inside.parent_path());
    std::ofstream("/proc/self/clear_refs") << 5; // the high-water mark starts anew
    [[maybe_unused]] const long memory = memoryOf("VmRSS:");
    const auto start = std::chrono::steady_clock::now();

    Submission submission;
    const std::string error = messageOf([&] { submission = readSubmission(inside); });

    EXPECT_LT(std::chrono::steady_clock::now() - start, kTime);
#ifndef __SANITIZE_ADDRESS__ // which keeps what was freed
    EXPECT_LT(memoryOf("VmHWM:") - memory, kMemory);
#endif
    std::filesystem::current_path(workingFolder);
    EXPECT_EQ(filesBelow(outside.path()), before);

    if (archive.refused != nullptr) {
        EXPECT_NE(error.find(archive.refused), std::string::npos) << error;
        return;
    }
    ASSERT_EQ(error, "(nothing was thrown)");
    std::string said = allNotes(submission);
    bool honest = false;
    for (const SubmittedFile &file : submission.files) {
        said += file.path + ": " + file.reason + "\n";
        EXPECT_TRUE(isUtf8(file.path)) << file.path;
        const bool used = file.role != FileRole::Ignored;
        EXPECT_FALSE(used && !pathFault(file.path).empty()) << file.path;
        honest = honest || (file.path == "src/mesh.cpp" && file.role == FileRole::Source &&
                            file.bytes == "// mesh\n");
    }
    EXPECT_NE(said.find(archive.said), std::string::npos) << said;
    EXPECT_EQ(honest, archive.honest) << said;
}

std::string nameOf(const testing::TestParamInfo<HostileArchive> &row) {
    return row.param.name;
}

INSTANTIATE_TEST_SUITE_P(Paths, Hostile, testing::ValuesIn(hostilePaths()), nameOf);
INSTANTIATE_TEST_SUITE_P(Entries, Hostile, testing::ValuesIn(hostileEntries()), nameOf);
INSTANTIATE_TEST_SUITE_P(Sizes, Hostile, testing::ValuesIn(hostileSizes()), nameOf);
INSTANTIATE_TEST_SUITE_P(Broken, Hostile, testing::ValuesIn(brokenArchives()), nameOf);

} // namespace

} // namespace grader::test
