// SPDX-License-Identifier: MIT
//
// Every archive of the tables: what comes of it, within bounds of time and memory, and no file
// anywhere.
#include <functional>
#include <map>
#include <set>

#include "hand_in.h"
#include "hostile_archives.h"

namespace grader::test {

void PrintTo(const HostileArchive &archive, std::ostream *stream) {
    *stream << archive.name;
}

namespace {

/// Everything below the folders that an archive could be unpacked to, with its bytes.
std::map<std::string, std::string> filesBelow(const std::filesystem::path &folder) {
    std::map<std::string, std::string> files;
    for (const auto &entry : std::filesystem::recursive_directory_iterator(folder)) {
        std::string &bytes = files[entry.path().string()];
        std::ifstream stream(entry.path(), std::ios::binary);
        if (entry.is_regular_file())
            bytes.assign(std::istreambuf_iterator<char>(stream), {});
    }
    return files;
}

class Hostile : public testing::TestWithParam<HostileArchive> {};

TEST_P(Hostile, ArchiveIsContained) {
    const TemporaryFolder outside;
    outside.write("warp.cpp", "// somebody's\n");
    outside.write("a/src/warp.cpp", "// somebody's\n");
    const auto inside = outside.write("a/b/p2_111111_222222.zip", GetParam().make());
    const auto before = filesBelow(outside.path());
    const auto workingFolder = std::filesystem::current_path();
    std::filesystem::current_path(inside.parent_path());
    const ReadArchive read = readHostileArchive(GetParam(), inside);
    std::filesystem::current_path(workingFolder);
    EXPECT_EQ(read.fault, "");
    EXPECT_TRUE(filesBelow(outside.path()) == before);
}

TEST(HostileArchives, AreManyAndNoneIsThereTwice) {
    std::set<std::string> names;
    std::set<std::size_t> contents;
    std::size_t count = 0;
    for (const auto &table : {hostilePaths(), hostileEntries(), hostileSizes(), brokenArchives()}) {
        for (const HostileArchive &archive : table) {
            names.insert(archive.name);
            contents.insert(std::hash<std::string>()(archive.make()));
            ++count;
        }
    }
    EXPECT_GE(count, 70U);
    EXPECT_EQ(names.size(), count);
    EXPECT_EQ(contents.size(), count);
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
