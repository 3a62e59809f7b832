// SPDX-License-Identifier: MIT
#include <grader/error.h>
#include <grader/text_file.h>

#include <gtest/gtest.h>

#include <unistd.h>

#include <iterator>

namespace grader {
namespace {

class TextFile : public testing::Test {
protected:
    void SetUp() override {
        m_folder = std::filesystem::temp_directory_path() /
                   ("norigrade_text_file_test." + std::to_string(::getpid()));
        std::filesystem::create_directories(m_folder);
    }

    void TearDown() override { std::filesystem::remove_all(m_folder); }

    std::ptrdiff_t filesIn(const std::filesystem::path &folder) const {
        return std::distance(std::filesystem::directory_iterator(folder), {});
    }

    std::filesystem::path m_folder;
};

TEST_F(TextFile, IsReadAsItWasWritten) {
    const std::string bytes("se\xc3\xb1or\r\n\0\xff", 10);
    writeTextFile(m_folder / "new folder" / "a", bytes);
    EXPECT_EQ(readTextFile(m_folder / "new folder" / "a"), bytes);
}

TEST_F(TextFile, IsReplacedAsAWhole) {
    writeTextFile(m_folder / "a", "long text");
    writeTextFile(m_folder / "a", "short");
    EXPECT_EQ(readTextFile(m_folder / "a"), "short");
    EXPECT_EQ(filesIn(m_folder), 1);
}

TEST_F(TextFile, LeavesNothingWhereItCannotBeWritten) {
    writeTextFile(m_folder / "folder" / "a", "");
    EXPECT_THROW(writeTextFile(m_folder / "folder", "text"), GraderError);
    EXPECT_EQ(filesIn(m_folder), 1);
    EXPECT_THROW(writeTextFile(m_folder / "folder" / "a" / "b", "text"), GraderError);
}

TEST_F(TextFile, ThatIsNotThereIsAnError) {
    EXPECT_THROW(readTextFile(m_folder / "none"), GraderError);
    EXPECT_THROW(readTextFile(m_folder), GraderError);
}

} // namespace
} // namespace grader
