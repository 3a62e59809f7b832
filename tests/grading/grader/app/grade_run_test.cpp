// SPDX-License-Identifier: MIT
#include <grader/app/grade_run.h>
#include <grader/error.h>
#include <grader/scoring/scoring.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <fstream>

namespace grader {
namespace {

namespace fs = std::filesystem;

/// Runs gradeAll() over folders that it makes, with a stand-in for the engine.
class GradeRunTest : public testing::Test {
protected:
    GradeRunTest() {
        m_rubric.items.resize(1);
        m_rubric.items[0].id = "warp.disk";
        m_rubric.items[0].title = "Disk";
        m_rubric.items[0].points = 100;
        m_rubric.items[0].checks = {{"warp.disk.density", Severity::Visible, 1, 0.01, 0.1}};
        fs::create_directories(m_folder);
        m_command.out = m_folder / "out";
        m_command.seed = "0000000000000000000000000000002a";
    }

    ~GradeRunTest() override { fs::remove_all(m_folder); }

    void addHandIn(const std::string &name) {
        const fs::path folder = m_folder / name;
        fs::create_directories(folder / "src");
        std::ofstream(folder / "src" / "warp.cpp") << "// " << name << "\n";
        m_command.paths.push_back(folder);
    }

    ExitCode run(const GradeFunction &grade) {
        return gradeAll({m_command, m_rubric, m_provenance, m_interrupted, "S3"}, grade);
    }

    /// A stand-in that gives every hand-in this verdict.
    GradeFunction giving(Verdict verdict) {
        return [this, verdict](const Submission &submission, const ProgressCallback &progress) {
            progress("checking", 0.5);
            CheckResult check;
            check.id = "warp.disk.density";
            check.verdict = verdict;
            SubmissionResult result;
            result.name = submission.name;
            score(m_rubric, {check}, result);
            return result;
        };
    }

    nlohmann::json results() const {
        std::ifstream file(m_command.out / "results.json");
        return nlohmann::json::parse(file);
    }

    const fs::path m_folder =
        fs::temp_directory_path() /
        ("norigrade_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) +
         std::to_string(::getpid()));
    GradeCommand m_command;
    Rubric m_rubric;
    Provenance m_provenance;
    std::atomic<bool> m_interrupted{false};
};

TEST_F(GradeRunTest, WritesResultsAndOnePagePerHandIn) {
    addHandIn("p2_111111_222222");
    addHandIn("sub/p2_111111_222222");
    EXPECT_EQ(run(giving(Verdict::Pass)), ExitCode::Done);

    const nlohmann::json json = results();
    ASSERT_EQ(json["submissions"].size(), 2u);
    EXPECT_EQ(json["submissions"][0]["total"], 100);
    EXPECT_EQ(json["submissions"][0]["files"][0]["path"], "src/warp.cpp");
    EXPECT_EQ(json["submissions"][0]["files"][0]["use"], "source");
    EXPECT_TRUE(fs::exists(m_command.out / "p2_111111_222222.html"));
    EXPECT_TRUE(fs::exists(m_command.out / "p2_111111_222222-2.html"));
}

TEST_F(GradeRunTest, SaysNothingAboutMarksByItsExitCode) {
    addHandIn("p2_111111");
    EXPECT_EQ(run(giving(Verdict::Fail)), ExitCode::Done);
    EXPECT_EQ(results()["submissions"][0]["total"], 0);
}

TEST_F(GradeRunTest, TellsACheckThatFails) {
    addHandIn("p2_111111");
    m_command.marked = false;
    EXPECT_EQ(run(giving(Verdict::Fail)), ExitCode::CheckFailed);
    EXPECT_TRUE(results()["submissions"][0]["total"].is_null());
    EXPECT_EQ(run(giving(Verdict::Pass)), ExitCode::Done);
    EXPECT_EQ(run(giving(Verdict::Inconclusive)), ExitCode::Done);
}

TEST_F(GradeRunTest, AsksNobodyWhoseTheWorkIsThatSomeoneChecks) {
    addHandIn("my_work");
    const auto withNotes = [this](const Submission &submission, const ProgressCallback &progress) {
        SubmissionResult result = giving(Verdict::Pass)(submission, progress);
        result.notes = submission.notes;
        return result;
    };
    EXPECT_EQ(run(withNotes), ExitCode::NeedsHuman);
    m_command.marked = false;
    EXPECT_EQ(run(withNotes), ExitCode::Done);
}

TEST_F(GradeRunTest, GoesOnAfterAHandInThatCannotBeRead) {
    addHandIn("p2_111111");
    std::ofstream(m_folder / "p2_333333.zip") << "this is no archive";
    m_command.paths.insert(m_command.paths.begin(), m_folder / "p2_333333.zip");
    EXPECT_EQ(run(giving(Verdict::Pass)), ExitCode::NeedsHuman);

    const nlohmann::json json = results();
    ASSERT_EQ(json["submissions"].size(), 2u);
    EXPECT_EQ(json["submissions"][0]["name"], "p2_333333");
    EXPECT_EQ(json["submissions"][0]["items"][0]["verdict"], "human");
    EXPECT_TRUE(json["submissions"][0]["total"].is_null());
    EXPECT_FALSE(json["submissions"][0]["final"]);
    EXPECT_EQ(json["submissions"][1]["total"], 100);
}

TEST_F(GradeRunTest, BlamesNobodyWhenTheEngineFails) {
    addHandIn("p2_111111");
    EXPECT_EQ(run([](const Submission &, const ProgressCallback &) -> SubmissionResult {
                  throw GraderError("the disk is full");
              }),
              ExitCode::Infra);
    EXPECT_EQ(results()["submissions"][0]["items"][0]["verdict"], "infra");
    EXPECT_EQ(results()["submissions"][0]["items"][0]["reason"],
              "Not graded, through no fault of the hand-in: the disk is full");
}

TEST_F(GradeRunTest, KeepsWhatWasDoneWhenItIsInterrupted) {
    addHandIn("p2_111111");
    addHandIn("p2_222222");
    addHandIn("p2_333333");
    const GradeFunction pass = giving(Verdict::Pass);
    int calls = 0;
    EXPECT_EQ(run([&](const Submission &submission, const ProgressCallback &progress) {
                  if (++calls == 2)
                      throw Interrupted();
                  return pass(submission, progress);
              }),
              ExitCode::Interrupted);
    EXPECT_EQ(results()["submissions"].size(), 1u);
    EXPECT_EQ(calls, 2);

    m_interrupted = true;
    EXPECT_EQ(run(pass), ExitCode::Interrupted);
    EXPECT_TRUE(results()["submissions"].empty());
}

TEST_F(GradeRunTest, WritesNothingWithoutAFolder) {
    addHandIn("p2_111111");
    m_command.out.clear();
    m_command.marked = false;
    EXPECT_EQ(run(giving(Verdict::Pass)), ExitCode::Done);
    EXPECT_EQ(std::distance(fs::directory_iterator(m_folder), fs::directory_iterator()), 1);
}

TEST_F(GradeRunTest, FindsAFolderThatCannotBeWrittenBeforeTheWork) {
    addHandIn("p2_111111");
    std::ofstream(m_folder / "file") << "x";
    m_command.out = m_folder / "file" / "out";
    bool called = false;
    EXPECT_THROW(run([&](const Submission &, const ProgressCallback &) {
                     called = true;
                     return SubmissionResult();
                 }),
                 GraderError);
    EXPECT_FALSE(called);
}

TEST_F(GradeRunTest, WritesTheSameResultsTwiceApartFromTimes) {
    addHandIn("p2_111111");
    run(giving(Verdict::Pass));
    nlohmann::json first = results();
    run(giving(Verdict::Pass));
    nlohmann::json second = results();
    for (nlohmann::json *json : {&first, &second})
        (*json)["submissions"][0].erase("times");
    EXPECT_EQ(first.dump(), second.dump());
}

} // namespace
} // namespace grader
