// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include <exam/measurement.h>
#include <exam/stability.h>
#include <exam/verdict_times.h>
#include <exam/work_folder.h>

namespace exam {

namespace {

namespace fs = std::filesystem;

/// A grader for which everything is right, but that ends with the code in `ends.NAME` as often as
/// is said there; before 75 it interrupts who has called it. Each grading makes a commit.
constexpr const char *kGrader = R"sh(#!/bin/sh
cd "$(dirname "$0")"
[ "$1" != calibrate ] || { echo "at most 1e-9"; exit; }
name=$(basename "$2")
echo call >>"calls.$name"
git -c user.name=x -c user.email=x commit -q --allow-empty -m later
if [ -e "ends.$name" ]; then
    read -r code times <"ends.$name"
    if [ "$(wc -l <"calls.$name")" -le "$times" ]; then
        [ "$code" != 75 ] || { kill -INT "$PPID"; sleep 0.2; }
        exit "$code"
    fi
fi
echo '{"submissions": [{"total": 10, "figures": [], "times": {"ingest": 0, "compile": 0,
    "link": 0, "sample": 0, "judge": 0, "figures": 0, "total": 1}, "items": [
    {"id": "warp.disk", "points": 10, "max": 10, "verdict": "pass", "reason": "", "diagnoses": [],
     "checks": []}]}]}'
)sh";

/// A project with two variants, two wrong hand-ins and a borderline one, under version control.
class Runs : public testing::Test {
protected:
    void SetUp() override {
        for (const char *folder :
             {"renderer", "grading/probe", "grading/protocol", "grading/rubrics", "scenes/grading",
              "scenes/assignment-2/serapis"})
            fs::create_directories(path(folder));
        write("norigrade", kGrader);
        fs::permissions(path("norigrade"), fs::perms::owner_all);
        for (const char *handIn :
             {"accepted/reference", "wrong/mesh_first_triangle_only", "wrong/ems_no_pick_pdf"}) {
            write(std::string("tests/submissions/") + handIn + "/expected.toml", "total = 10\n");
            write(std::string("tests/submissions/") + handIn + "/src/warp.cpp",
                  std::string("one ") + handIn);
        }
        const std::string patch = "base = \"accepted/reference\"\nwhat = \"w\"\n[[change]]\n"
                                  "file = \"src/warp.cpp\"\nold = \"one\"\nnew = ";
        write("tests/variants/two.toml", patch + "\"two\"\n");
        write("tests/variants/three.toml", patch + "\"three\"\n");
        write("tests/borderline/near.toml",
              "item = \"warp.disk\"\ncost = \"visible\"\n" + patch + "\"near\"\n");
        std::string sections;
        for (const char *name : {"variants", "stability", "false-alarms"})
            sections += std::string("<!-- ") + name + ": begin -->\n<!-- " + name + ": end -->\n";
        write("exam.md", sections);
        const std::string begin = "cd '" + m_folder.path().string() +
                                  "' && git init -q && git -c user.name=x -c user.email=x commit "
                                  "-q --allow-empty -m first && git describe --always >first";
        ASSERT_EQ(std::system(begin.c_str()), 0);
    }

    fs::path path(const std::string &name) const { return m_folder.path() / name; }

    void write(const std::string &name, const std::string &text) const {
        fs::create_directories(path(name).parent_path());
        std::ofstream(path(name)) << text;
    }

    std::string read(const std::string &name) const {
        std::ifstream stream(path(name));
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    std::size_t calls(const std::string &name) const { return read("calls." + name).size() / 5; }

    /// What a record says of the commit before the first grading.
    std::string firstCommit() const { return "at commit `" + read("first").substr(0, 7); }

    int run(int (*verb)(int, char **), std::vector<std::string> arguments) const {
        const std::vector<std::string> places = {"--project", path("").string(), "--norigrade",
                                                 path("norigrade").string()};
        arguments.insert(arguments.begin() + 1, places.begin(), places.end());
        std::vector<char *> pointers;
        pointers.reserve(arguments.size());
        for (std::string &argument : arguments)
            pointers.push_back(argument.data());
        return verb(static_cast<int>(pointers.size()), pointers.data());
    }

    int variants(std::vector<std::string> more) const {
        more.insert(more.begin(),
                    {"variants", "--cache", path("cache").string(), "--whole", "1", "--jobs", "1"});
        return run(measure, more);
    }

    std::string record() const { return path("exam.md").string(); }

    WorkFolder m_folder;
};

} // namespace

TEST_F(Runs, grade_again_where_the_grader_itself_failed) {
    write("ends.two", "5 2\n");
    EXPECT_EQ(variants({"--record", record()}), 0);
    EXPECT_EQ(calls("two"), 3U);
    EXPECT_EQ(calls("three"), 1U);
    const std::string again = "In this call 1 grading needed another try";
    EXPECT_NE(read("exam.md").find(again), std::string::npos) << read("exam.md");
    EXPECT_EQ(variants({"--record", record()}), 0);
    EXPECT_EQ(read("exam.md").find(again), std::string::npos) << "all is known";
}

TEST_F(Runs, set_aside_what_cannot_be_graded_and_go_on) {
    write("ends.three", "5 9\n");
    EXPECT_EQ(variants({"--record", record()}), 1);
    EXPECT_EQ(calls("three"), 3U);
    EXPECT_EQ(calls("two"), 1U);
    const std::string text = read("exam.md");
    EXPECT_NE(text.find("lose nothing: 1 of 1"), std::string::npos) << text;
    EXPECT_NE(text.find("failed 3 times:\n\n- three --seed 00"), std::string::npos) << text;
    EXPECT_EQ(text.find("another try"), std::string::npos) << text;
    EXPECT_EQ(variants({}), 1);
    EXPECT_EQ(calls("two"), 1U) << "it is known";
}

TEST_F(Runs, go_on_where_they_were_interrupted) {
    write("ends.two", "75 1\n");
    const std::string before = read("exam.md");
    EXPECT_EQ(variants({"--record", record()}), 75);
    EXPECT_EQ(calls("three"), 1U);
    EXPECT_EQ(calls("two"), 1U);
    EXPECT_EQ(read("exam.md"), before);
    EXPECT_EQ(variants({"--record", record()}), 0);
    EXPECT_EQ(calls("three"), 1U) << "it is known";
    EXPECT_EQ(calls("two"), 2U);
    EXPECT_NE(read("exam.md").find("lose nothing: 2 of 2"), std::string::npos);
}

TEST_F(Runs, print_the_times_that_were_measured_before_an_interruption) {
    write("tests/mutants/far.toml", read("tests/borderline/near.toml"));
    const auto measured = [&](const std::string &handIn) {
        write("ends." + handIn, "75 1\n");
        testing::internal::CaptureStderr();
        EXPECT_EQ(run(measureVerdictTimes, {"verdict-times"}), 75);
        return testing::internal::GetCapturedStderr();
    };
    EXPECT_NE(measured("reference").find("0 of "), std::string::npos) << "the base";
    EXPECT_NE(measured("ems_no_pick_pdf").find("1 of "), std::string::npos);
}

TEST_F(Runs, end_where_the_grader_cannot_run) {
    write("ends.three", "4 1\n");
    EXPECT_THROW(variants({}), ExamError);
    EXPECT_EQ(calls("three"), 1U);
    EXPECT_EQ(calls("two"), 0U);
    EXPECT_EQ(variants({}), 0);
}

TEST_F(Runs, name_the_commit_that_was_graded) {
    EXPECT_EQ(variants({"--record", record()}), 0);
    const std::string text = read("exam.md");
    EXPECT_NE(text.find("Measured " + firstCommit()), std::string::npos) << text;
}

TEST_F(Runs, leave_what_was_set_aside_out_of_what_is_stable) {
    write("ends.ems_no_pick_pdf", "5 9\n");
    EXPECT_EQ(run(measureStability, {"stability", "--cache", path("cache").string(),
                                     "--unoptimised", path("norigrade").string(), "--seeds", "2",
                                     "--settings", "1", "--jobs", "1", "--record", record()}),
              1);
    const std::string text = read("exam.md");
    EXPECT_NE(text.find("Measured " + firstCommit()), std::string::npos) << text;
    EXPECT_NE(text.find("Composed " + firstCommit()), std::string::npos) << text;
    EXPECT_NE(text.find("| accepted/reference | accepted | 2 | 10 |"), std::string::npos) << text;
    EXPECT_EQ(text.find("| wrong/ems_no_pick_pdf |"), std::string::npos) << text;
    EXPECT_NE(text.find("- wrong/ems_no_pick_pdf --seed 00"), std::string::npos) << text;
    EXPECT_NE(text.find(" --jobs 2\n"), std::string::npos) << text;
}

TEST_F(Runs, record_no_part_of_a_table) {
    EXPECT_EQ(variants({"--only", "two", "--record", record()}), 2);
    EXPECT_EQ(run(measureVerdictTimes, {"verdict-times", "--only", "two", "--record", record()}),
              2);
    EXPECT_EQ(calls("two"), 0U);
    EXPECT_EQ(variants({"--only", "two"}), 0);
    EXPECT_EQ(variants({"--help"}), 0);
}

} // namespace exam
