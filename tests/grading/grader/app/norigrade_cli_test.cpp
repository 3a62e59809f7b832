// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <fstream>

#include <exam/command.h>
#include <exam/grading.h>
#include <exam/hand_in.h>

namespace {

using Json = nlohmann::json;

/// The program itself on whole hand-ins.
class Norigrade : public testing::Test {
protected:
    void SetUp() override {
        m_scratch = std::filesystem::temp_directory_path() /
                    ("norigrade_cli_test." + std::to_string(::getpid()));
        std::filesystem::create_directories(m_scratch);
    }

    void TearDown() override { std::filesystem::remove_all(m_scratch); }

    exam::Outcome run(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), NORIGRADE);
        return exam::runCommand(arguments, m_scratch);
    }

    std::filesystem::path m_scratch;
};

const std::string kReference =
    std::string(NORI_SOURCE_DIR) + "/tests/submissions/accepted/reference";

/// results.json without what it says of times.
std::string withoutTimes(const std::filesystem::path &folder) {
    std::ifstream stream(folder / "results.json");
    Json json = Json::parse(stream);
    for (Json &submission : json["submissions"])
        submission.erase("times");
    return json.dump();
}

TEST_F(Norigrade, WritesTheSameResultsForTheSameSeedHoweverManyJobsRun) {
    for (const char *jobs : {"1", "2"}) {
        const exam::Outcome outcome = run({"grade", kReference, "--seed", "5", "--jobs", jobs,
                                           "--out", (m_scratch / jobs).string()});
        // The folder's name does not tell whose work it is: someone has to look.
        EXPECT_EQ(outcome.exitCode, 3) << outcome.output << outcome.errors;
        EXPECT_NE(outcome.output.find("100 of 100"), std::string::npos) << outcome.output;
    }
    EXPECT_EQ(withoutTimes(m_scratch / "1"), withoutTimes(m_scratch / "2"));
}

TEST_F(Norigrade, GradesOneItemAsInAWholeRun) {
    // The triangle is wrong, and the area light samples with it: what it stands on is charged
    // there.
    const std::filesystem::path submissions =
        std::filesystem::path(NORI_SOURCE_DIR) / "tests" / "submissions";
    const exam::Case which = exam::findCases(submissions, "triangle_without_sqrt").at(0);
    const std::filesystem::path handIn = exam::compose(submissions, which, NORIGRADE, m_scratch);
    const exam::Outcome outcome =
        run({"grade", handIn.string(), "--seed", "5", "--json", "--item", "area_light"});
    const exam::Graded graded = exam::parseResults(outcome.output);
    ASSERT_EQ(graded.items.size(), 1u);
    EXPECT_EQ(graded.items[0].id, "area_light");
    EXPECT_EQ(graded.total, 30);
    const exam::Outcome unknown = run({"grade", handIn.string(), "--item", "area"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_NE(unknown.errors.find("no item \"area\""), std::string::npos) << unknown.errors;
}

/// A rubric of one item, and a corpus of a right hand-in, a wrong one and what is handed out.
struct SmallCourse {
    explicit SmallCourse(const std::filesystem::path &folder)
        : rubric(folder / "disk.toml"), corpus(folder / "corpus") {
        std::ofstream(rubric) << "schema = 1\n[assignment]\nid = \"disk\"\ntitle = \"Disk\"\n"
                                 "cap = 10\nextras = \"ignore\"\nmin_sandbox = \"S2\"\n"
                                 "[[item]]\nid = \"warp.disk\"\ntitle = \"Disk\"\npoints = 10\n";
        for (const char *handIn :
             {"accepted/reference", "starter/unmodified", "wrong/disk_pdf_one"}) {
            const std::filesystem::path to = corpus / "submissions" / handIn;
            std::filesystem::create_directories(to.parent_path());
            std::filesystem::copy(std::filesystem::path(NORI_SOURCE_DIR) / "tests/submissions" /
                                      handIn,
                                  to, std::filesystem::copy_options::recursive);
        }
    }

    /// A hand-in that is right, whatever is said of it.
    void addAsWrong(const char *handIn) const {
        const std::filesystem::path folder = corpus / "submissions/wrong" / handIn;
        std::filesystem::create_directories(folder);
        std::ofstream(folder / "expected.toml")
            << "base = \"accepted/reference\"\nlost = [\"warp.disk\"]\n";
    }

    std::filesystem::path rubric, corpus;
};

TEST_F(Norigrade, FreezesARubricThatTellsTheCorpusApart) {
    const SmallCourse course(m_scratch);
    const exam::Outcome outcome = run({"calibrate", course.rubric.string(), "--corpus",
                                       course.corpus.string(), "--freeze", "--class-size", "30"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.output << outcome.errors;
    EXPECT_NE(outcome.output.find("ok   submissions/wrong/disk_pdf_one"), std::string::npos)
        << outcome.output;
    EXPECT_NE(outcome.output.find("3 of 3 hand-ins are told apart"), std::string::npos)
        << outcome.output;
    EXPECT_NE(outcome.output.find("for 30 hand-ins"), std::string::npos) << outcome.output;
    EXPECT_TRUE(std::filesystem::exists(course.rubric.string() + ".frozen"));
}

TEST_F(Norigrade, RefusesToFreezeARubricThatDoesNotAndSaysWhatIsMissing) {
    const SmallCourse course(m_scratch);
    course.addAsWrong("nobody_sees_it");
    const exam::Outcome outcome =
        run({"calibrate", course.rubric.string(), "--corpus", course.corpus.string(), "--freeze"});
    EXPECT_EQ(outcome.exitCode, 1) << outcome.output << outcome.errors;
    EXPECT_NE(outcome.output.find("MISS submissions/wrong/nobody_sees_it\n"
                                  "       the mistake is free: no check of warp.disk finds it, "
                                  "one is missing"),
              std::string::npos)
        << outcome.output;
    EXPECT_NE(outcome.errors.find("not frozen: the rubric does not tell all hand-ins apart"),
              std::string::npos)
        << outcome.errors;
    EXPECT_FALSE(std::filesystem::exists(course.rubric.string() + ".frozen"));
}

TEST_F(Norigrade, RefusesToFreezeWhatWasNotTriedOnTheStarter) {
    const SmallCourse course(m_scratch);
    std::filesystem::remove_all(course.corpus / "submissions/starter");
    const exam::Outcome outcome =
        run({"calibrate", course.rubric.string(), "--corpus", course.corpus.string(), "--freeze"});
    EXPECT_EQ(outcome.exitCode, 1) << outcome.output << outcome.errors;
    EXPECT_NE(outcome.errors.find("not frozen: what is handed out was not tried"),
              std::string::npos)
        << outcome.errors;
}

TEST_F(Norigrade, SaysWhatIsWrongWithItsArguments) {
    const exam::Outcome missing = run({"grade", (m_scratch / "p2_1_2.zip").string()});
    EXPECT_EQ(missing.exitCode, 2);
    EXPECT_NE(missing.errors.find("p2_1_2.zip: no such file or folder"), std::string::npos)
        << missing.errors;
    const exam::Outcome unknown = run({"grrade"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_NE(unknown.errors.find("grrade"), std::string::npos) << unknown.errors;
}

} // namespace
