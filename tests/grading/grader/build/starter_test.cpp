// SPDX-License-Identifier: MIT
#include <grader/build/base.h>
#include <grader/build/starter.h>
#include <grader/error.h>
#include <grader/text_file.h>
#include <support/work_folder.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace grader {
namespace {

TEST(Starter, ReplacesAGradedBodyByAThrow) {
    const auto text = starterText("float f() {\n"
                                  "    // graded: begin f() is not yet implemented!\n"
                                  "    return 1;\n"
                                  "    // graded: end\n"
                                  "}\n",
                                  "f.cpp");
    EXPECT_EQ(text, "float f() {\n    throw NoriException(\"f() is not yet implemented!\");\n}\n");
}

TEST(Starter, RemovesARegionWithoutAMessage) {
    EXPECT_EQ(starterText("a\n// graded: begin\nsecret\n// graded: end\nb\n", "f"), "a\nb\n");
}

TEST(Starter, UncommentsTheReplacement) {
    EXPECT_EQ(starterText("  // graded: begin\n  right\n  // graded: else\n  //# naive\n"
                          "  // graded: end\n",
                          "f"),
              "  naive\n");
}

TEST(Starter, KeepsTheSolutionsItIsAskedForAndWhatAllNeed) {
    const std::string text = "// graded: begin\nhelper\n// graded: end\n"
                             "// graded: begin W::f() is not done!\nof f\n// graded: end\n"
                             "// graded: begin W::fPdf() is not done!\nof fPdf\n// graded: end\n";
    EXPECT_EQ(starterText(text, "w.cpp", {"W::f"}),
              "helper\nof f\nthrow NoriException(\"W::fPdf() is not done!\");\n");
}

TEST(Starter, LeavesOutWholeFiles) {
    EXPECT_EQ(starterText("// SPDX\n// graded: file\nsecret\n", "f"), std::nullopt);
}

TEST(Starter, KeepsALastLineWithoutEnd) {
    EXPECT_EQ(starterText("a\nb", "f"), "a\nb");
}

TEST(Starter, NamesFileAndLineOfAMisplacedMarker) {
    for (const char *text :
         {"// graded: end\n", "a\n// graded: begin\n// graded: begin\n", "// graded: begin\nx\n",
          "// graded: bgin\n", "// graded: begin\n// graded: else\nnot marked\n// graded: end\n"}) {
        try {
            starterText(text, "mesh.cpp");
            FAIL() << "accepted: " << text;
        } catch (const GraderError &error) {
            EXPECT_NE(std::string(error.what()).find("mesh.cpp"), std::string::npos)
                << error.what();
        }
    }
}

TEST(Starter, HoldsNoSolutionButAllThatIsGiven) {
    const Base &starter = starterBase();
    const Base &reference = referenceBase();
    EXPECT_EQ(starter.units.count("direct_ems.cpp"), 0u);
    EXPECT_EQ(reference.units.count("direct_ems.cpp"), 1u);
    EXPECT_EQ(starter.units.size() + 1, reference.units.size());
    EXPECT_EQ(reference.units.count("direct_mis.cpp"), 0u) << "no submission's build has it";
    for (const auto &[name, text] : starter.units)
        EXPECT_EQ(text.find("graded:"), std::string::npos) << name;
    // What each graded file gives away when it is not stripped.
    const std::pair<const char *, const char *> solutions[] = {
        {"warp.cpp", "sqrt"},
        {"mesh.cpp", "sampleReuse"},
        {"area.cpp", "samplePosition"},
        {"scene.cpp", "m_emitterPdf"},
        {"environment.cpp", "squareToUniformSphere"}};
    for (const auto &[unit, word] : solutions) {
        EXPECT_NE(reference.units.at(unit).find(word), std::string::npos) << unit;
        EXPECT_EQ(starter.units.at(unit).find(word), std::string::npos) << unit;
    }
    EXPECT_EQ(starter.headers.at("nori/scene.h").find("m_emitterPdf"), std::string::npos);
    EXPECT_EQ(starter.headers.at("nori/emitter.h").find("power"), std::string::npos);
}

/// What a file includes in quotes, from the folder `app`.
std::set<std::string> quotedIncludes(const std::filesystem::path &file) {
    std::set<std::string> names;
    std::istringstream lines(readTextFile(file));
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("#include \"", 0) == 0)
            names.insert(line.substr(10, line.find('"', 10) - 10));
    }
    return names;
}

TEST(Starter, HasOrMakesEveryHeaderOfItsProgram) {
    const support::WorkFolder folder;
    writeStarter(folder.path());
    const std::string lists = readTextFile(folder.path() / "CMakeLists.txt");
    for (const auto &entry : std::filesystem::directory_iterator(folder.path() / "app")) {
        if (!entry.is_regular_file())
            continue;
        for (const std::string &name : quotedIncludes(entry.path())) {
            const bool isMade = lists.find("configure_file(app/" + name + ".in") != lists.npos;
            EXPECT_TRUE(isMade || std::filesystem::exists(folder.path() / "app" / name))
                << entry.path() << ": " << name;
        }
    }
}

TEST(Starter, IsWrittenAsAProjectWithoutGraderOrSolution) {
    const auto folder = std::filesystem::temp_directory_path() / "norigrade-starter-test";
    std::filesystem::remove_all(folder);
    writeStarter(folder);
    EXPECT_TRUE(std::filesystem::exists(folder / "CMakeLists.txt"));
    EXPECT_TRUE(std::filesystem::exists(folder / "include/nori/warp.h"));
    EXPECT_TRUE(std::filesystem::exists(folder / "compat/pcg32.h"));
    EXPECT_TRUE(std::filesystem::exists(folder / "src/warp.cpp"));
    EXPECT_TRUE(std::filesystem::exists(folder / "scenes/assignment-2/cbox/cbox_ems.xml"));
    EXPECT_FALSE(std::filesystem::exists(folder / "src/direct_ems.cpp"));
    EXPECT_FALSE(std::filesystem::exists(folder / "src/direct_mis.cpp"));
    EXPECT_FALSE(std::filesystem::exists(folder / "compat/probe"));
    for (const auto &entry :
         std::filesystem::recursive_directory_iterator(folder / "scenes/assignment-2")) {
        if (entry.path().extension() != ".xml")
            continue;
        for (const char *ours : {"emitterSampling", "\"sampling\"", "applyRotate"})
            EXPECT_EQ(readTextFile(entry.path()).find(ours), std::string::npos)
                << entry.path() << " can only be rendered by the reference";
    }
    EXPECT_THROW(writeStarter(folder), GraderError) << "must not write into a folder with files";
    std::filesystem::remove_all(folder);
}

} // namespace
} // namespace grader
