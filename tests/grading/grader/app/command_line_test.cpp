// SPDX-License-Identifier: MIT
#include <grader/app/command_line.h>

#include <gtest/gtest.h>

#include <set>

namespace grader {
namespace {

using Arguments = std::vector<std::string>;

GradeCommand gradeCommand(const Arguments &arguments) {
    const Command command = parseCommandLine(arguments);
    EXPECT_TRUE(std::holds_alternative<GradeCommand>(command));
    return std::get<GradeCommand>(command);
}

std::string mistake(const Arguments &arguments) {
    const Command command = parseCommandLine(arguments);
    return std::holds_alternative<UsageMistake>(command) ? std::get<UsageMistake>(command).message
                                                         : "no mistake";
}

std::string printed(const Arguments &arguments) {
    const Command command = parseCommandLine(arguments);
    return std::holds_alternative<PrintCommand>(command) ? std::get<PrintCommand>(command).text
                                                         : "";
}

TEST(CommandLine, ReadsGradeWithOptionsInAnyOrder) {
    const GradeCommand command =
        gradeCommand({"grade", "--jobs", "3", "a.zip", "--out", "o", "b c", "--json", "--rubric",
                      "r.toml", "--seed", "2A", "--quiet", "--item", "warp.disk", "--item", "x"});
    EXPECT_TRUE(command.marked);
    EXPECT_EQ(command.paths, (std::vector<std::filesystem::path>{"a.zip", "b c"}));
    EXPECT_EQ(command.rubric, "r.toml");
    EXPECT_EQ(command.items, (std::vector<std::string>{"warp.disk", "x"}));
    EXPECT_EQ(command.out, "o");
    EXPECT_EQ(command.jobs, 3);
    EXPECT_EQ(command.seed, "0000000000000000000000000000002a");
    EXPECT_TRUE(command.json);
    EXPECT_TRUE(command.quiet);
}

TEST(CommandLine, LeavesWhatIsNotGivenEmpty) {
    const GradeCommand command = gradeCommand({"grade", "a.zip"});
    EXPECT_TRUE(command.rubric.empty());
    EXPECT_TRUE(command.items.empty());
    EXPECT_TRUE(command.out.empty());
    EXPECT_TRUE(command.seed.empty());
    EXPECT_GE(command.jobs, 1);
    EXPECT_FALSE(command.json);
    EXPECT_FALSE(command.quiet);
}

TEST(CommandLine, ReadsTheOtherVerbs) {
    EXPECT_FALSE(gradeCommand({"check", "."}).marked);
    EXPECT_TRUE(std::holds_alternative<DoctorCommand>(parseCommandLine({"doctor"})));
    EXPECT_EQ(std::get<LintCommand>(parseCommandLine({"lint", "r.toml"})).rubric, "r.toml");
    EXPECT_EQ(std::get<StarterCommand>(parseCommandLine({"starter", "d"})).folder, "d");
    const auto references = std::get<ReferencesCommand>(
        parseCommandLine({"references", "a.xml", "--full-size", "b.xml", "--out", "d"}));
    EXPECT_EQ(references.scenes, (std::vector<std::string>{"a.xml", "b.xml"}));
    EXPECT_TRUE(references.fullSize);
    EXPECT_FALSE(references.verify);
    EXPECT_EQ(references.out, "d");
    EXPECT_NE(mistake({"references", "--full-size"}).find("needs --out"), std::string::npos);
}

TEST(CommandLine, ReadsCalibrateAndLanguages) {
    const auto calibrate = std::get<CalibrateCommand>(
        parseCommandLine({"calibrate", "r.toml", "--seeds", "3", "--freeze", "--corpus", "c"}));
    EXPECT_EQ(calibrate.rubric, "r.toml");
    EXPECT_EQ(calibrate.seeds, 3);
    EXPECT_EQ(calibrate.corpus, "c");
    EXPECT_EQ(calibrate.classSize, 300);
    EXPECT_TRUE(calibrate.freeze);
    EXPECT_FALSE(calibrate.boundOnly);
    // A part says nothing of the whole: found before the work, not after it.
    EXPECT_NE(mistake({"calibrate", "r.toml", "--freeze", "--only", "disk"}).find("--only"),
              std::string::npos);
    EXPECT_NE(mistake({"calibrate", "r.toml", "--freeze", "--bound"}).find("--bound"),
              std::string::npos);
    EXPECT_TRUE(std::holds_alternative<UsageMistake>(parseCommandLine({"calibrate"})));
    const auto languageWith = [](const char *code) {
        return std::get<GradeCommand>(parseCommandLine({"check", "a", "--lang", code})).language;
    };
    EXPECT_EQ(languageWith("es"), Language::Spanish);
    EXPECT_EQ(languageWith("en"), Language::English);
    EXPECT_TRUE(
        std::holds_alternative<UsageMistake>(parseCommandLine({"check", "a", "--lang", "fr"})));
}

TEST(CommandLine, TakesAFileNameThatLooksLikeAnOptionAfterTwoDashes) {
    EXPECT_EQ(gradeCommand({"grade", "--", "-rf"}).paths,
              (std::vector<std::filesystem::path>{"-rf"}));
}

TEST(CommandLine, SuggestsWhatWasMeant) {
    EXPECT_EQ(mistake({"gread", "x"}), "there is no verb \"gread\" (did you mean \"grade\"?)");
    EXPECT_EQ(mistake({"grade", "--rubik", "x", "y"}),
              "there is no option --rubik (did you mean \"--rubric\"?)\n"
              "norigrade grade --help tells more");
    EXPECT_EQ(mistake({"grade", "--sede=1", "y"}),
              "there is no option --sede (did you mean \"--seed\"?)\n"
              "norigrade grade --help tells more");
}

TEST(CommandLine, RefusesWhatIsMissingOrOutOfRange) {
    EXPECT_NE(mistake({"grade"}).find("PATH"), std::string::npos);
    EXPECT_NE(mistake({"check", "a", "b"}), "no mistake");
    EXPECT_NE(mistake({"doctor", "a"}), "no mistake");
    EXPECT_NE(mistake({"lint"}), "no mistake");
    for (const char *seed : {"", "g", "0x1", "-1", "123456789012345678901234567890123"})
        EXPECT_NE(mistake({"grade", "a", "--seed", seed}), "no mistake") << seed;
    for (const char *jobs : {"0", "-1", "257", "many", "1.5", ""})
        EXPECT_NE(mistake({"grade", "a", "--jobs", jobs}), "no mistake") << jobs;
}

TEST(CommandLine, GivesHelpWithExamplesForEachVerb) {
    EXPECT_NE(printed({}).find("norigrade grade p2_123456_654321.zip"), std::string::npos);
    EXPECT_NE(printed({"--help"}).find("Exit codes"), std::string::npos);
    for (const char *verb : {"grade", "check", "doctor", "lint", "starter"}) {
        EXPECT_NE(printed({verb, "--help"}).find("Example"), std::string::npos) << verb;
        EXPECT_NE(printed({verb, "--help"}).find(std::string("norigrade ") + verb),
                  std::string::npos);
        EXPECT_NE(printed({"--help"}).find(verb), std::string::npos) << verb;
    }
}

TEST(CommandLine, SaysItsVersion) {
    EXPECT_EQ(printed({"--version"}).substr(0, 10), "norigrade ");
}

TEST(FreshSeed, IsThirtyTwoDigitsThatDoNotRepeat) {
    std::set<std::string> seeds;
    for (int i = 0; i < 100; ++i) {
        const std::string seed = freshSeed();
        EXPECT_EQ(seed.size(), 32u);
        EXPECT_EQ(seed.find_first_not_of("0123456789abcdef"), std::string::npos);
        EXPECT_TRUE(seeds.insert(seed).second);
    }
}

TEST(CommandLine, ReadsCompareWithOneReferenceOrTwoHalves) {
    const auto compare = [](const Arguments &arguments) {
        return std::get<CompareCommand>(parseCommandLine(arguments));
    };
    const CompareCommand pair = compare({"compare", "--json", "a.exr", "b.exr", "--level", "1e-6",
                                         "--reference-spp", "1024", "--tiles", "z.png"});
    EXPECT_EQ(pair.image, "a.exr");
    EXPECT_EQ(pair.references, (std::vector<std::filesystem::path>{"b.exr"}));
    EXPECT_EQ(pair.level, 1e-6);
    EXPECT_EQ(pair.referenceSpp, 1024);
    EXPECT_EQ(pair.tiles, "z.png");
    EXPECT_TRUE(pair.json);
    EXPECT_EQ(compare({"compare", "a.exr", "--reference", "b.exr", "c.exr"}).references,
              (std::vector<std::filesystem::path>{"b.exr", "c.exr"}));
    EXPECT_NE(mistake({"compare", "a.exr"}).find("needs a second image"), std::string::npos);
    EXPECT_NE(mistake({"compare", "a.exr", "b.exr", "--reference", "c.exr"}), "no mistake");
    EXPECT_NE(mistake({"compare", "a.exr", "b.exr", "--level", "2"}), "no mistake");
}

TEST(CommandLine, ReadsConvergeWithLists) {
    const auto converge = [](const Arguments &arguments) {
        return std::get<ConvergeCommand>(parseCommandLine(arguments));
    };
    const ConvergeCommand command =
        converge({"converge", "a.xml", "b.xml", "--integrator", "direct_ems,direct_mis", "--spp",
                  "1,8", "--replicates", "3", "--width", "99", "--out", "o", "--seed", "2a"});
    EXPECT_EQ(command.scenes, (std::vector<std::filesystem::path>{"a.xml", "b.xml"}));
    EXPECT_EQ(command.integrators, (std::vector<std::string>{"direct_ems", "direct_mis"}));
    EXPECT_EQ(command.samples, (std::vector<int>{1, 8}));
    EXPECT_EQ(command.replicates, 3);
    EXPECT_EQ(command.width, 99);
    EXPECT_EQ(command.out, "o");
    EXPECT_EQ(command.seed, "2a");
    EXPECT_EQ(converge({"converge", "a.xml"}).samples, (std::vector<int>{1, 4, 16, 64}));
    EXPECT_EQ(converge({"converge", "a.xml", "--against", "p2_1.zip"}).against, "p2_1.zip");
    EXPECT_TRUE(converge({"converge", "a.xml"}).against.empty());
    EXPECT_NE(mistake({"converge"}), "no mistake");
    EXPECT_NE(mistake({"converge", "a.xml", "--reference", "a.exr"}), "no mistake");
    EXPECT_NE(mistake({"converge", "a.xml", "--replicates", "1"}), "no mistake");
    EXPECT_NE(mistake({"converge", "a.xml", "--spp", "0"}), "no mistake");
}

} // namespace
} // namespace grader
