// SPDX-License-Identifier: MIT
#include "hand_in.h"

namespace grader::test {
namespace {

const std::string kWarp =
    "#include <nori/warp.h>\nPoint2f Warp::squareToTent(const Point2f &s) {}\n";
const std::string kArea = "float AreaEmitter::pdf() const {}\nNORI_REGISTER_CLASS(AreaEmitter, "
                          "\"area\")\n";

TEST(Layout, ReadsAHandInAsTheHandoutAsksForIt) {
    const Submission submission = readZip({{"README.txt", "Autores: Ana (111111), Íñigo (222222)"},
                                           {"src/warp.cpp", kWarp},
                                           {"src/mesh.cpp", "// m"},
                                           {"src/area.cpp", kArea},
                                           {"src/environment.cpp", "// e"},
                                           {"src/direct_ems.cpp", "// d"},
                                           {"figures/UniformDisk.png", "png"}});
    EXPECT_EQ(submission.name, "p2_111111_222222");
    EXPECT_EQ(submission.members, (std::vector<std::string>{"111111", "222222"}));
    EXPECT_EQ(submission.digest.size(), 64U);
    EXPECT_EQ(roleOf(submission, "README.txt"), FileRole::Readme);
    EXPECT_EQ(roleOf(submission, "figures/UniformDisk.png"), FileRole::Figure);
    for (const char *name :
         {"warp.cpp", "mesh.cpp", "area.cpp", "environment.cpp", "direct_ems.cpp"}) {
        EXPECT_NE(submission.find(FileRole::Source, name), nullptr) << name;
    }
    EXPECT_TRUE(hasNote(submission, Note::Level::Odd, "UniformTriangle.png"));
    EXPECT_TRUE(hasNote(submission, Note::Level::Odd, "serapis_ems_64.exr"));
    EXPECT_FALSE(hasNote(submission, Note::Level::Human, "")) << allNotes(submission);
}

TEST(Layout, FindsSourcesWhereverTheyLie) {
    for (const char *prefix : {"", "p2_111111_222222/src/", "repo/Nori2/src/", "lab2/"}) {
        const Submission submission = readZip({{std::string(prefix) + "warp.cpp", kWarp}});
        EXPECT_NE(submission.find(FileRole::Source, "warp.cpp"), nullptr) << prefix;
    }
}

TEST(Layout, TakesAHeaderInTheSourceFolderForTheBases) {
    const Submission submission = readZip(
        {{"src/emitter.h", "// e"}, {"include/nori/Scene.H", "// s"}, {"src/tools.hpp", ""}});
    EXPECT_NE(submission.find(FileRole::Header, "emitter.h"), nullptr);
    EXPECT_NE(submission.find(FileRole::Header, "scene.h"), nullptr);
    EXPECT_NE(submission.find(FileRole::Header, "tools.hpp"), nullptr);
    EXPECT_TRUE(hasNote(submission, Note::Level::Odd, "is taken for scene.h"));
}

TEST(Layout, TakesWrongCaseForTheBasesName) {
    const Submission submission = readZip({{"SRC/Warp.CPP", kWarp}});
    EXPECT_NE(submission.find(FileRole::Source, "warp.cpp"), nullptr);
    EXPECT_TRUE(hasNote(submission, Note::Level::Odd, "'SRC/Warp.CPP' is taken for warp.cpp"));
}

TEST(Layout, CleansTextButKeepsItsBytes) {
    const Submission submission =
        readZip({{"src/warp.cpp", "\xEF\xBB\xBF// ca\xF1on\r\nint a;\rint b;\n"}});
    EXPECT_EQ(submission.find(FileRole::Source, "warp.cpp")->bytes,
              "// ca\xF1on\nint a;\nint b;\n");
}

TEST(Layout, ConvertsUtf16AndRefusesZeroBytes) {
    const Submission submission =
        readZip({{"src/warp.cpp", std::string("\xFF\xFEi\0n\0t\0\r\0\n\0", 12)},
                 {"src/area.cpp", std::string("int\0 a;", 7)}});
    EXPECT_EQ(submission.find(FileRole::Source, "warp.cpp")->bytes, "int\n");
    EXPECT_TRUE(hasNote(submission, Note::Level::Odd, "UTF-16"));
    EXPECT_EQ(roleOf(submission, "src/area.cpp"), FileRole::Ignored);
    EXPECT_TRUE(hasNote(submission, Note::Level::Human, "zero bytes"));
}

TEST(Layout, KeepsTheGradersOwnFiles) {
    for (const char *name : {"main.cpp", "parser.cpp", "Independent.cpp", "chi2test.cpp"}) {
        const Submission submission = readZip({{"warp.cpp", kWarp}, {name, "int main() {}"}});
        EXPECT_EQ(roleOf(submission, name), FileRole::Ignored) << name;
        EXPECT_TRUE(hasNote(submission, Note::Level::Odd, "the base's own")) << name;
    }
}

TEST(Layout, LeavesCopiesOut) {
    for (const char *name :
         {"area_COPY.cpp", "area_old.cpp", "area_PEPE.cpp", "area - copia.cpp", "area (1).cpp",
          "area2.cpp", "area-v1.cpp", "Copia de area.cpp", "old_area.cpp", "area_original.cpp"}) {
        const Submission submission =
            readZip({{"src/area.cpp", kArea}, {std::string("src/") + name, kArea + "// other"}});
        EXPECT_EQ(roleOf(submission, std::string("src/") + name), FileRole::Ignored) << name;
        EXPECT_TRUE(hasNote(submission, Note::Level::Odd, "was not used")) << name;
        EXPECT_NE(submission.find(FileRole::Source, "area.cpp"), nullptr) << name;
    }
    const Submission others = readZip({{"warp.cpp", kWarp},
                                       {"main_2.cpp", "int main() {}"},
                                       {"main_old.cpp", "int main() {}"},
                                       {"normals-v1.cpp", "class N"},
                                       {"node.cpp", " \r\n"}});
    for (const char *name : {"main_2.cpp", "main_old.cpp", "normals-v1.cpp", "node.cpp"}) {
        EXPECT_EQ(roleOf(others, name), FileRole::Ignored) << name;
    }
}

TEST(Layout, KeepsFurtherSourcesThatOnlyLookLikeCopies) {
    const Submission submission =
        readZip({{"src/warp.cpp", kWarp},
                 {"src/warp_tools.cpp", "float Tools::half() {}"},
                 {"src/light_tree.cpp", "int LightTree::size() {}"},
                 {"src/threshold.cpp", "int x;"},
                 {"src/base_tools.cpp", "int y;"},
                 {"src/depth_field.cpp", "NORI_REGISTER_CLASS(Field, \"depth_field\");"}});
    for (const char *name : {"src/base_tools.cpp", "src/depth_field.cpp", "src/warp_tools.cpp",
                             "src/light_tree.cpp", "src/threshold.cpp"}) {
        EXPECT_EQ(roleOf(submission, name), FileRole::Extra) << name;
    }
}

TEST(Layout, AsksForAPersonWhenOnlyACopyWasHandedIn) {
    const Submission submission = readZip({{"warp.cpp", kWarp}, {"area_v2.cpp", kArea}});
    EXPECT_EQ(submission.find(FileRole::Source, "area.cpp"), nullptr);
    EXPECT_TRUE(hasNote(submission, Note::Level::Human, "'area_v2.cpp' looks like a copy"));
}

TEST(Layout, TakesAFileByTheTypeThatItRegisters) {
    const Submission submission = readZip(
        {{"warp.cpp", kWarp},
         {"DirectEmitterSampling.cpp",
          "// NORI_REGISTER_CLASS(No, \"area\")\nNORI_REGISTER_CLASS(Direct, \"direct_ems\");"}});
    ASSERT_NE(submission.find(FileRole::Source, "direct_ems.cpp"), nullptr);
    EXPECT_EQ(submission.find(FileRole::Source, "direct_ems.cpp")->path,
              "DirectEmitterSampling.cpp");
    EXPECT_EQ(submission.find(FileRole::Source, "area.cpp"), nullptr);
}

TEST(Layout, LeavesOutASecondDefinitionUnderAnotherName) {
    const Submission submission = readZip({{"area.cpp", kArea}, {"luz.cpp", kArea + "// mine"}});
    EXPECT_EQ(roleOf(submission, "luz.cpp"), FileRole::Ignored);
    EXPECT_TRUE(hasNote(submission, Note::Level::Odd, "defines what 'area.cpp' defines"));
}

TEST(Layout, PrefersTheSourceFolderAmongFilesOfTheSameName) {
    const Submission submission = readZip(
        {{"old/warp.cpp", "// old"}, {"a/src/warp.cpp", "// used"}, {"warp.cpp", "// root"}});
    EXPECT_EQ(submission.find(FileRole::Source, "warp.cpp")->bytes, "// used");
    EXPECT_TRUE(hasNote(submission, Note::Level::Human,
                        "two different files for warp.cpp: 'a/src/warp.cpp' was used, "
                        "'old/warp.cpp' was not"));
    const Submission same = readZip({{"src/warp.cpp", kWarp}, {"warp.cpp", kWarp}});
    EXPECT_FALSE(hasNote(same, Note::Level::Human, "warp.cpp"));
    EXPECT_EQ(roleOf(same, "warp.cpp"), FileRole::Ignored);
}

TEST(Layout, GivesClutterAReason) {
    const Submission submission = readZip({{"src/warp.cpp", kWarp},
                                           {"__MACOSX/src/._warp.cpp", "x"},
                                           {"src/._warp.cpp", "x"},
                                           {".DS_Store", "x"},
                                           {"Thumbs.db", "x"},
                                           {"build/CMakeFiles/warp.cpp", "x"},
                                           {"src/warp.o", "x"},
                                           {"nori.exe", "x"},
                                           {"handout.pdf", "x"},
                                           {"mesh.mtl", "x"},
                                           {"data.bin", "x"},
                                           {"CMakeLists.txt", "add_executable(nori src/warp.cpp "
                                                              "src/lost.cpp)"}});
    std::size_t ignored = 0;
    for (const SubmittedFile &file : submission.files) {
        EXPECT_FALSE(file.reason.empty()) << file.path;
        ignored += file.role == FileRole::Ignored ? 1U : 0U;
    }
    EXPECT_EQ(ignored, 11U);
    EXPECT_NE(findPath(submission, "__MACOSX/"), nullptr);
    EXPECT_EQ(submission.find(FileRole::Source, "warp.cpp")->bytes, kWarp);
    EXPECT_TRUE(hasNote(submission, Note::Level::Odd, "lost.cpp"));
}

TEST(Layout, UsesOnlyReplaceableHeadersOfAWholeProject) {
    Files files{{"Nori2/src/warp.cpp", kWarp}};
    for (const char *name : {"accel", "bbox", "bitmap", "block", "bsdf", "camera", "color",
                             "common", "dpdf", "emitter", "frame", "integrator", "mesh", "scene"}) {
        files.emplace_back(std::string("Nori2/include/nori/") + name + ".h", "// h");
    }
    const Submission submission = readZip(files);
    EXPECT_NE(submission.find(FileRole::Header, "emitter.h"), nullptr);
    EXPECT_EQ(submission.find(FileRole::Header, "accel.h"), nullptr);
    EXPECT_TRUE(hasNote(submission, Note::Level::Odd, "Nori2/include/nori/accel.h, "));
}

TEST(Layout, LeavesOtherAssignmentsOut) {
    const Submission submission = readZip({{"all/p2_111111_222222/src/warp.cpp", kWarp},
                                           {"all/p1_111111_222222/src/pointlight.cpp", "// p1"}});
    EXPECT_EQ(submission.find(FileRole::Source, "pointlight.cpp"), nullptr);
    EXPECT_TRUE(hasNote(submission, Note::Level::Odd, "another assignment"));
}

TEST(Layout, RefusesNamesThatAToolCouldMisread) {
    const Submission submission = readZip({{"src/warp.cpp", kWarp},
                                           {"src/-o.cpp", "int a;"},
                                           {"src/@x.cpp", "int a;"},
                                           {"src/$(id).cpp", "int a;"},
                                           {"src/--config=x.h", "int a;"}});
    for (const char *name : {"src/-o.cpp", "src/@x.cpp", "src/$(id).cpp", "src/--config=x.h"}) {
        EXPECT_EQ(roleOf(submission, name), FileRole::Ignored) << name;
    }
}

TEST(Layout, TellsNothingOfTheAssignmentFromAnError) {
    const Submission wrong = readZip({{"essay.docx", "x"}});
    EXPECT_TRUE(hasNote(wrong, Note::Level::Human, "nothing of the assignment"));
    const Submission empty = readZip({});
    EXPECT_TRUE(hasNote(empty, Note::Level::Human, "is empty"));
    const TemporaryFolder folder;
    EXPECT_TRUE(hasNote(readSubmission(folder.path()), Note::Level::Human, "is empty"));
}

TEST(Layout, OpensANestedArchive) {
    const std::string inner = makeZip({{"src/warp.cpp", kWarp}, {"README.md", "hola"}});
    const Submission submission = readZip({{"p2_111111_222222.zip", inner}}, "upload.zip");
    EXPECT_EQ(roleOf(submission, "p2_111111_222222.zip/src/warp.cpp"), FileRole::Source);
    EXPECT_EQ(submission.members, (std::vector<std::string>{"111111", "222222"}));
    EXPECT_FALSE(hasNote(submission, Note::Level::Human, "")) << allNotes(submission);
}

TEST(Layout, PutsNestedPartsTogetherUnlessSeveralHoldSources) {
    const std::string sources = makeZip({{"warp.cpp", kWarp}});
    const std::string figures = makeZip({{"UniformDisk.png", "p"}});
    const Submission parts = readZip({{"src.zip", sources}, {"figures.zip", figures}});
    EXPECT_NE(parts.find(FileRole::Source, "warp.cpp"), nullptr);
    EXPECT_NE(parts.find(FileRole::Figure, "UniformDisk.png"), nullptr);

    const Submission two = readZip({{"a.zip", sources}, {"b.zip", sources}});
    EXPECT_EQ(two.find(FileRole::Source, "warp.cpp"), nullptr);
    EXPECT_TRUE(hasNote(two, Note::Level::Human, "'a.zip' holds sources"));

    const Submission beside = readZip({{"area.cpp", kArea}, {"old.zip", sources}});
    EXPECT_EQ(beside.find(FileRole::Source, "warp.cpp"), nullptr);
    EXPECT_TRUE(hasNote(beside, Note::Level::Human, "'old.zip' holds sources"));
}

TEST(Layout, OpensArchivesOnlyTwoDeep) {
    std::string archive = makeZip({{"warp.cpp", kWarp}});
    for (int depth = 0; depth < 3; ++depth) {
        archive = makeZip({{"inner.zip", archive}});
    }
    const Submission submission = readBytes(archive);
    EXPECT_EQ(submission.find(FileRole::Source, "warp.cpp"), nullptr);
    EXPECT_TRUE(hasNote(submission, Note::Level::Human, "more than 2 archives deep"));
}

} // namespace
} // namespace grader::test
