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
