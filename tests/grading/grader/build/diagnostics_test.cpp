// SPDX-License-Identifier: MIT
#include <grader/build/diagnostics.h>

#include <gtest/gtest.h>

namespace grader {
namespace {

struct Case {
    const char *unit;
    const char *log;
    const char *missing;
    const char *probablyIn;
};

// Lines as g++ 12 and ld print them in the C locale.
const Case kCases[] = {
    {"scene.cpp",
     "src/scene.cpp: In member function 'virtual void nori::Scene::activate()':\n"
     "src/scene.cpp:41:5: error: 'm_emitterPDF' was not declared in this scope\n",
     "m_emitterPDF", "scene.h"},
    {"area.cpp",
     "src/area.cpp: In constructor 'nori::AreaEmitter::AreaEmitter(const nori::PropertyList&)':\n"
     "src/area.cpp:20:5: error: 'class nori::Emitter' has no member named 'm_power'\n",
     "m_power", "emitter.h"},
    {"direct_ems.cpp",
     "src/direct_ems.cpp:30:25: error: 'const class nori::Scene' has no member named "
     "'importanceSampleEmitter'\n",
     "importanceSampleEmitter", "scene.h"},
    {"warp.cpp", "src/warp.cpp:9:10: fatal error: nori/concentric.h: No such file or directory\n",
     "nori/concentric.h", "concentric.h"},
    {"scene.cpp",
     "src/scene.cpp:70:6: error: no declaration matches 'float nori::Scene::sampleDirect(float)'\n",
     "sampleDirect", "scene.h"},
    {"link",
     "/usr/bin/ld.gold: /objects/3.o: in function nori::AreaEmitter::sample: undefined reference "
     "to "
     "`nori::Helper::pick(float)'\n",
     "pick", "helper.cpp"},
};

TEST(Diagnostics, NameWhatIsMissingAndWhereItProbablyIs) {
    for (const Case &row : kCases) {
        const BuildFailure failure = parseDiagnostics(row.unit, row.log, {});
        EXPECT_EQ(failure.missing, row.missing) << row.log;
        EXPECT_EQ(failure.probablyIn, row.probablyIn) << row.log;
        EXPECT_EQ(failure.errors.size(), 1u) << row.log;
    }
}

TEST(Diagnostics, SayThatAHeaderWasNotSent) {
    const BuildFailure failure =
        parseDiagnostics("scene.cpp",
                         "In file included from src/scene.cpp:2:\n"
                         "/hand-in/include/nori/scene.h:5:10: fatal error: utils.h: No such file "
                         "or directory\n",
                         {{"/hand-in/include/nori/scene.h", "p2/src/scene.h"}});
    EXPECT_EQ(failure.describe(), "scene.cpp does not compile: p2/src/scene.h:5: utils.h: No such "
                                  "file or directory (\"utils.h\" is not among the files)");
}

TEST(Diagnostics, DoNotBlameTheClassOfTheFunctionBefore) {
    const BuildFailure failure =
        parseDiagnostics("mesh.cpp",
                         "src/mesh.cpp: In destructor 'virtual nori::Mesh::~Mesh()':\n"
                         "src/mesh.cpp:13:5: error: expected ';' before 'delete'\n"
                         "src/mesh.cpp: At global scope:\n"
                         "src/mesh.cpp:90:9: error: 'helper' was not declared in this scope\n",
                         {});
    EXPECT_EQ(failure.missing, "helper");
    EXPECT_EQ(failure.probablyIn, "");
}

TEST(Diagnostics, ShowTheHandInsOwnPath) {
    const BuildFailure failure =
        parseDiagnostics("warp.cpp", "src/warp.cpp:12:5: error: expected ';' before 'return'\n",
                         {{"src/warp.cpp", "Práctica 2/src/Warp.cpp"}});
    ASSERT_EQ(failure.errors.size(), 1u);
    EXPECT_EQ(failure.errors[0].file, "Práctica 2/src/Warp.cpp");
    EXPECT_EQ(failure.errors[0].line, 12);
    EXPECT_EQ(failure.describe(), "warp.cpp does not compile: Práctica 2/src/Warp.cpp:12: expected "
                                  "';' before 'return'");
}

TEST(Diagnostics, SurviveVeryLongLinesAndNoErrorAtAll) {
    EXPECT_TRUE(parseDiagnostics("a.cpp", std::string(1 << 20, 'x'), {}).errors.empty());
    EXPECT_TRUE(parseDiagnostics("a.cpp", "", {}).errors.empty());
}

} // namespace
} // namespace grader
