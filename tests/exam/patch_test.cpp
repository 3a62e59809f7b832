// SPDX-License-Identifier: MIT
#include <grader/diagnosis/catalogue.h>

#include <gtest/gtest.h>

#include <unistd.h>

#include <fstream>
#include <iterator>

#include <exam/hand_in.h>
#include <exam/judgement.h>

namespace exam {

namespace {

namespace fs = std::filesystem;

const fs::path kTests = fs::path(NORI_SOURCE_DIR) / "tests";

class Patches : public testing::Test {
protected:
    void SetUp() override {
        m_folder = fs::temp_directory_path() / ("patch_test." + std::to_string(getpid()));
        fs::create_directories(m_folder / "work");
    }

    void TearDown() override { fs::remove_all(m_folder); }

    Patch read(const std::string &text) const {
        std::ofstream(m_folder / "one.toml") << text;
        return findPatches(m_folder, "").front();
    }

    std::string applied(const Patch &patch, const std::string &file) const {
        std::ifstream stream(apply(patch, kTests / "submissions", m_folder / "work") / file,
                             std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    fs::path m_folder;
};

const std::string kHead = "what = \"w\"\nbase = \"accepted/reference\"\n";
const std::string kDisk = "item = \"warp.disk\"\ncost = \"visible\"\n";

std::string change(const std::string &before) {
    return "[[change]]\nfile = \"src/warp.cpp\"\nold = \"" + before + "\"\nnew = \"42\"\n";
}

} // namespace

TEST_F(Patches, change_one_text_and_nothing_else) {
    const Patch patch = read(kHead + kDisk + change("sqrt(sample.x());\\n    float angulo"));
    EXPECT_EQ(patch.name, "one");
    EXPECT_EQ(patch.cost, Patch::Cost::Visible);
    const std::string text = applied(patch, "src/warp.cpp");
    EXPECT_NE(text.find("float radio = 42 ="), std::string::npos);
    EXPECT_FALSE(fs::exists(m_folder / "work" / "one" / "expected.toml"));
}

TEST_F(Patches, leave_files_out) {
    const Patch patch = read("without = [\"src/scene.cpp\"]\n" + kHead);
    EXPECT_TRUE(applied(patch, "src/scene.cpp").empty());
    EXPECT_FALSE(applied(patch, "src/warp.cpp").empty());
    EXPECT_THROW(applied(read("without = [\"src/none.cpp\"]\n" + kHead), ""), ExamError);
}

TEST_F(Patches, do_not_apply_where_the_text_is_gone_or_there_twice) {
    EXPECT_THROW(applied(read(kHead + kDisk + change("no such text")), ""), ExamError);
    EXPECT_THROW(applied(read(kHead + kDisk + change("float")), ""), ExamError);
    EXPECT_THROW(applied(read("what = \"w\"\nbase = \"accepted/none\"\n"), ""), ExamError);
}

TEST_F(Patches, refuse_a_change_that_changes_nothing) {
    try {
        read(kHead + kDisk + change("42"));
        ADD_FAILURE() << "not refused";
    } catch (const ExamError &error) {
        EXPECT_NE(std::string(error.what()).find("one.toml:5: old and new are the same"),
                  std::string::npos)
            << error.what();
    }
}

TEST_F(Patches, end_lines_as_windows_does) {
    const std::string text = applied(read(kHead + "crlf = true\n"), "src/warp.cpp");
    EXPECT_NE(text.find("NORI_NAMESPACE_BEGIN\r\n"), std::string::npos);
    EXPECT_EQ(text.find("\r\r"), std::string::npos);
}

TEST_F(Patches, refuse_what_they_do_not_know) {
    for (const std::string text :
         {"basis = \"x\"\n", "what = \"w\"\n", "item = \"warp.disk\"\n", "cost = \"much\"\n",
          "[[change]]\nfile = \"src/warp.cpp\"\n", "[[file]]\nfile = \"a\"\nold = \"b\"\n"})
        EXPECT_THROW(read(kHead + text + (text == "what = \"w\"\n" ? "[" : "")), ExamError) << text;
    EXPECT_THROW(findPatches(m_folder, "nothing is called so"), ExamError);
}

TEST_F(Patches, of_the_corpus_all_apply) {
    for (const char *corpus : {"mutants", "borderline", "variants"}) {
        for (const Patch &patch : findPatches(kTests / corpus, "")) {
            EXPECT_NO_THROW(apply(patch, kTests / "submissions", m_folder / "work"));
            fs::remove_all(m_folder / "work");
            EXPECT_EQ(patch.item.empty(), std::string(corpus) == "variants") << patch.name;
        }
    }
}

TEST(Diagnoses, that_are_asked_for_are_all_in_the_catalogue) {
    const auto expectKnown = [](const std::string &id, const std::string &where) {
        EXPECT_NE(grader::findDiagnosis(id), nullptr) << where << ": " << id;
    };
    for (const char *corpus : {"mutants", "borderline", "variants"}) {
        for (const Patch &patch : findPatches(kTests / corpus, "")) {
            for (const std::string &id : patch.diagnoses)
                expectKnown(id, patch.name);
        }
    }
    for (const Case &which : findCases(kTests / "submissions", "")) {
        if (const std::string &id = which.expectation.diagnosis; !id.empty())
            expectKnown(id, which.name);
    }
    for (const std::string &id : catchAlls())
        expectKnown(id, "catchAlls()");
}

} // namespace exam
