// SPDX-License-Identifier: MIT
#include <grader/calibration/corpus.h>
#include <grader/calibration/measurements.h>
#include <grader/error.h>
#include <grader/text_file.h>

#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>

namespace grader {

namespace {

namespace fs = std::filesystem;

/// A small corpus in a folder that goes at the end.
class CorpusTest : public testing::Test {
protected:
    CorpusTest() {
        m_root = fs::temp_directory_path() / ("corpus-" + std::to_string(::getpid()));
        write("submissions/accepted/all/expected.toml", "total = 100\n");
        write("submissions/accepted/all/src/warp.cpp", "return 1;\n");
        write("submissions/hostile/forks/expected.toml", "hostile = true\n");
        write("submissions/wrong/disk/expected.toml",
              "base = \"accepted/all\"\nlost = [\"warp.disk\"]\n");
        write("submissions/wrong/disk/src/warp.cpp", "return 2;\n");
        write("mutants/disk/three.toml",
              "what = \"It is three.\"\nbase = \"accepted/all\"\nitem = \"warp.disk\"\n"
              "[[change]]\nfile = \"src/warp.cpp\"\nold = \"1\"\nnew = \"3\"\n");
        write("mutants/disk/remark.toml", "base = \"accepted/all\"\ncost = \"blemish\"\n");
    }

    ~CorpusTest() override { fs::remove_all(m_root); }

    void write(const std::string &name, const std::string &text) const {
        fs::create_directories((m_root / name).parent_path());
        writeTextFile(m_root / name, text);
    }

    std::string composed(const std::string &only) const {
        const fs::path to = m_root / "composed";
        fs::remove_all(to);
        fs::create_directories(to);
        composeCase(readCorpus(m_root, only).at(0), to);
        return readTextFile(to / "src/warp.cpp");
    }

    fs::path m_root;
};

} // namespace

TEST_F(CorpusTest, holds_what_says_something_of_a_rubric) {
    const std::vector<CorpusCase> cases = readCorpus(m_root, "");
    ASSERT_EQ(cases.size(), 3U);
    EXPECT_EQ(cases[0].name, "mutants/disk/three");
    EXPECT_EQ(cases[0].what, "It is three.");
    EXPECT_EQ(cases[0].lost, std::vector<std::string>{"warp.disk"});
    EXPECT_EQ(cases[2].name, "submissions/wrong/disk");
}

TEST_F(CorpusTest, lays_files_and_changes_over_the_base) {
    EXPECT_EQ(composed("accepted"), "return 1;\n");
    EXPECT_EQ(composed("wrong"), "return 2;\n");
    EXPECT_EQ(composed("three"), "return 3;\n");
}

TEST_F(CorpusTest, says_what_is_wrong_with_it) {
    EXPECT_THROW(readCorpus(m_root, "nothing like this"), GraderError);
    EXPECT_THROW(readCorpus(m_root / "mutants", ""), GraderError);
    write("mutants/disk/three.toml",
          "base = \"accepted/all\"\nitem = \"warp.disk\"\n"
          "[[change]]\nfile = \"src/warp.cpp\"\nold = \"4\"\nnew = \"3\"\n");
    EXPECT_THROW(composed("three"), GraderError);
    write("mutants/disk/three.toml",
          "base = \"accepted/all\"\nitem = \"warp.disk\"\n"
          "[[change]]\nfile = \"src/warp.cpp\"\nold = \"1\"\nnew = \"1\"\n");
    EXPECT_THROW(composed("three"), GraderError);
    write("mutants/disk/three.toml",
          "base = \"accepted/all\"\nitem = \"warp.disk\"\nwithout = [\"src/scene.cpp\"]\n");
    EXPECT_THROW(composed("three"), GraderError);
    write("mutants/disk/three.toml", "base = \n");
    EXPECT_THROW(readCorpus(m_root, ""), GraderError);
}

TEST_F(CorpusTest, keeps_measurements_without_points) {
    CheckResult check;
    check.id = "warp.disk.samples";
    check.verdict = Verdict::Fail;
    check.effect = 0.25;
    check.diagnoses = {{"disk.missing_sqrt", 0.9}};
    CheckResult other;
    other.verdict = Verdict::Missing;
    writeMeasurements(m_root / "kept/a.json", {check, other});
    const auto read = readMeasurements(m_root / "kept/a.json");
    ASSERT_TRUE(read.has_value());
    EXPECT_EQ((*read)[0].id, check.id);
    EXPECT_EQ((*read)[0].effect, 0.25);
    EXPECT_EQ((*read)[0].diagnoses[0].id, "disk.missing_sqrt");
    EXPECT_EQ((*read)[1].verdict, Verdict::Missing);
    EXPECT_TRUE(std::isnan((*read)[1].effect));
    write("kept/b.json", "[{");
    EXPECT_FALSE(readMeasurements(m_root / "kept/b.json").has_value());
    EXPECT_FALSE(readMeasurements(m_root / "kept/c.json").has_value());
}

} // namespace grader
