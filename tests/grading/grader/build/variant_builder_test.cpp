// SPDX-License-Identifier: MIT
#include <grader/build/variant_builder.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace grader {
namespace {

/// One cache for all tests of this program: the base is compiled once.
class VariantBuilderTest : public testing::Test {
protected:
    static void SetUpTestSuite() {
        ASSERT_GE(s_sandbox.level(), SandboxLevel::S2) << s_sandbox.findings().back();
    }

    static Submission handIn(std::vector<SubmittedFile> files) {
        Submission submission;
        submission.name = "p2_1_2";
        submission.files = std::move(files);
        return submission;
    }

    static SubmittedFile source(const std::string &name, const std::string &text) {
        return {"src/" + name, name, FileRole::Source, "", text};
    }

    static inline const Sandbox s_sandbox{SandboxLevel::S3};
    static inline const Cache s_cache{std::filesystem::temp_directory_path() /
                                      "norigrade-test-cache"};
};

const std::string &referenceUnit(const std::string &name) {
    return referenceBase().units.at(name);
}

TEST_F(VariantBuilderTest, BuildsOurOwnUpstreamOverTheStarterInBothConventions) {
    Compiler compiler(s_sandbox, s_cache);
    const Submission empty = handIn({});
    VariantBuilder builder(compiler, empty, 2);
    for (const Origin origin : {Origin::Reference, Origin::ReferenceValue}) {
        const Variant variant = builder.build({"ours",
                                               {{"warp.cpp", origin},
                                                {"mesh.cpp", origin},
                                                {"area.cpp", origin},
                                                {"environment.cpp", origin}}});
        EXPECT_TRUE(variant.executable.has_value());
        for (const BuildFailure &failure : variant.failures)
            ADD_FAILURE() << failure.describe();
    }
}

TEST_F(VariantBuilderTest, TriesOnceWhatRunsIntoALimit) {
    const Sandbox sandbox;
    if (sandbox.level() < SandboxLevel::S3 && std::getenv("CI") == nullptr)
        GTEST_SKIP() << "at S2 the assembler ends by itself when its memory is used up";
    Compiler compiler(sandbox, s_cache);
    const Submission bomb = handIn(
        {source("warp.cpp", "__asm__(\".rept 100000000\\n .quad 1,2,3,4,5,6,7,8\\n .endr\");\n")});
    VariantBuilder builder(compiler, bomb, 1);
    const auto first = builder.failureOf("warp.cpp");
    ASSERT_TRUE(first.has_value());
    EXPECT_NE(first->describe().find("the compiler was stopped"), std::string::npos);
    const double seconds = compiler.compileSeconds();
    EXPECT_GT(seconds, 0);
    const auto second = builder.failureOf("warp.cpp");
    ASSERT_TRUE(second.has_value());
    EXPECT_EQ(second->describe(), first->describe());
    EXPECT_EQ(compiler.compileSeconds(), seconds);
}

TEST_F(VariantBuilderTest, SurvivesAddedPureVirtualsInTheEmitter) {
    Compiler compiler(s_sandbox, s_cache);
    std::string emitter = starterBase().headers.at("nori/emitter.h");
    const std::string mark = "virtual Color3f eval(const EmitterQueryRecord &lRec) const = 0;";
    const std::size_t at = emitter.find(mark);
    ASSERT_NE(at, std::string::npos);
    emitter.insert(at + mark.size(), "\n    virtual Color3f radiance() const = 0;\n"
                                     "    virtual Color3f power() const = 0;\n"
                                     "    virtual float getLuminance() const = 0;\n");
    const Submission submission =
        handIn({{"src/emitter.h", "emitter.h", FileRole::Header, "", emitter}});
    VariantBuilder builder(compiler, submission, 2);
    const Variant variant = builder.build({"ours", {{"area.cpp", Origin::Reference}}});
    EXPECT_TRUE(variant.executable.has_value());
    for (const BuildFailure &failure : variant.failures)
        ADD_FAILURE() << failure.describe();
}

TEST_F(VariantBuilderTest, LetsTheStarterStandInForAFileThatDoesNotCompile) {
    Compiler compiler(s_sandbox, s_cache);
    const Submission submission = handIn({source("scene.cpp", referenceUnit("scene.cpp")),
                                          source("warp.cpp", referenceUnit("warp.cpp"))});
    VariantBuilder builder(compiler, submission, 2);
    // Our scene.cpp needs the members that the starter's scene.h does not have.
    const auto failure = builder.failureOf("scene.cpp");
    ASSERT_TRUE(failure.has_value());
    EXPECT_EQ(failure->probablyIn, "scene.h");
    EXPECT_FALSE(builder.failureOf("warp.cpp").has_value());
    const Variant variant =
        builder.build({"student", {{"scene.cpp", Origin::Student}, {"warp.cpp", Origin::Student}}});
    EXPECT_TRUE(variant.executable.has_value());
    EXPECT_EQ(variant.failures.size(), 1u);
}

TEST_F(VariantBuilderTest, JudgesWhatNeedsNoBrokenHeaderWithoutIt) {
    Compiler compiler(s_sandbox, s_cache);
    const std::string scene =
        "#include \"utils.h\"\n" + starterBase().headers.at("nori/scene.h"); // not handed in
    const Submission submission =
        handIn({source("warp.cpp", referenceUnit("warp.cpp")),
                source("scene.cpp", referenceUnit("scene.cpp")),
                {"src/scene.h", "scene.h", FileRole::Header, "", scene},
                {"src/helper.h", "helper.h", FileRole::Header, "", "int helper();\n"}});
    VariantBuilder builder(compiler, submission, 2);
    builder.compileAll([](double) {});
    const std::vector<Note> notes = builder.notes();
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_NE(notes[0].text.find("src/scene.h:1: utils.h: No such file"), std::string::npos)
        << notes[0].text;
    EXPECT_FALSE(builder.failureOf("warp.cpp").has_value());
    EXPECT_TRUE(builder.failureOf("scene.cpp").has_value());
    EXPECT_TRUE(builder.build({"student", {{"warp.cpp", Origin::Student}}}).executable.has_value());
}

TEST_F(VariantBuilderTest, TakesTheHandInsOwnFileWhereItsHeaderBreaksTheBases) {
    Compiler compiler(s_sandbox, s_cache);
    const auto renamed = [](std::string text) {
        for (std::size_t at = 0; (at = text.find("m_emitters", at)) != std::string::npos;)
            text.replace(at, 10, "m_luces");
        return text;
    };
    const Submission submission =
        handIn({source("warp.cpp", referenceUnit("warp.cpp")),
                source("scene.cpp", renamed(starterBase().units.at("scene.cpp"))),
                {"src/scene.h", "scene.h", FileRole::Header, "",
                 renamed(starterBase().headers.at("nori/scene.h"))}});
    VariantBuilder builder(compiler, submission, 2);
    builder.compileAll([](double) {});
    EXPECT_TRUE(builder.notes().empty());
    EXPECT_FALSE(builder.failureOf("scene.cpp").has_value());
    EXPECT_TRUE(builder.build({"student", {{"warp.cpp", Origin::Student}}}).executable.has_value());
}

/// emitter.h with one more pure virtual, which our area.cpp does not have.
SubmittedFile strictEmitterHeader() {
    std::string text = starterBase().headers.at("nori/emitter.h");
    const std::size_t at = text.find("virtual Color3f eval(");
    text.insert(at, "virtual int kind() const = 0;\n    ");
    return {"src/emitter.h", "emitter.h", FileRole::Header, "", text};
}

TEST_F(VariantBuilderTest, LeavesOutHeadersThatOursDoesNotGoWithWhereTheJudgedFileNeedsNone) {
    Compiler compiler(s_sandbox, s_cache);
    const Submission submission =
        handIn({source("direct_ems.cpp", referenceUnit("direct_ems.cpp")), strictEmitterHeader()});
    VariantBuilder builder(compiler, submission, 2);
    VariantPlan plan{"ours",
                     {{"area.cpp", Origin::Reference}, {"direct_ems.cpp", Origin::Student}},
                     {"direct_ems.cpp"}};
    Variant variant = builder.build(plan);
    EXPECT_TRUE(variant.executable.has_value());
    EXPECT_TRUE(variant.isWhole);
    EXPECT_TRUE(variant.failures.empty());
    // A judged file that needs them keeps them, and what is missing is told.
    const Submission needing = handIn(
        {source("direct_ems.cpp", referenceUnit("direct_ems.cpp") +
                                      "int f(const nori::Emitter &e) { return e.kind(); }\n"),
         strictEmitterHeader()});
    VariantBuilder other(compiler, needing, 2);
    EXPECT_FALSE(other.build(plan).isWhole);
}

TEST_F(VariantBuilderTest, LinksExtraFilesOnlyWhereTheyAreNeeded) {
    Compiler compiler(s_sandbox, s_cache);
    std::string warp = referenceUnit("warp.cpp");
    warp += "\nfloat helper();\nfloat useHelper() { return helper(); }\n";
    const SubmittedFile needed{"src/ayuda ñ.cpp", "ayuda ñ.cpp", FileRole::Extra, "",
                               "float helper() { return 1; }\n"};
    // A copy of a file that is there already: its definitions must not clash.
    const SubmittedFile copy{"src/old.cpp", "old.cpp", FileRole::Extra, "",
                             referenceUnit("warp.cpp")};
    const Submission submission = handIn({source("warp.cpp", warp), needed, copy});
    VariantBuilder builder(compiler, submission, 2);
    const Variant variant = builder.build({"student", {{"warp.cpp", Origin::Student}}});
    EXPECT_TRUE(variant.executable.has_value())
        << (variant.failures.empty() ? "" : variant.failures[0].describe());

    const Submission without = handIn({source("warp.cpp", warp)});
    VariantBuilder lacking(compiler, without, 2);
    const Variant broken = lacking.build({"student", {{"warp.cpp", Origin::Student}}});
    EXPECT_FALSE(broken.executable.has_value());
    ASSERT_FALSE(broken.failures.empty());
    EXPECT_NE(broken.failures[0].missing.find("helper"), std::string::npos)
        << broken.failures[0].describe();
}

TEST_F(VariantBuilderTest, ShowsNoHostFileToTheCompiler) {
    Compiler compiler(s_sandbox, s_cache);
    const Submission submission =
        handIn({source("warp.cpp", "#include \"/etc/passwd\"\n"),
                source("mesh.cpp", "__asm__(\".incbin \\\"/etc/passwd\\\"\");\n")});
    VariantBuilder builder(compiler, submission, 2);
    EXPECT_TRUE(builder.failureOf("warp.cpp").has_value());
    EXPECT_TRUE(builder.failureOf("mesh.cpp").has_value());
}

} // namespace
} // namespace grader
