// SPDX-License-Identifier: MIT
#include "calibrate_options.h"

#include <cstdlib>

namespace grader {

namespace {

constexpr char kCalibrateExamples[] = R"(
Grades right and wrong hand-ins of the project: right ones must keep every point, a wrong one must
lose on the item of its mistake and on no other. They are nearly 400 gradings, about 20 seconds
each on two cores. What was measured is kept: an interrupted call goes on, and with other weights a
second call only adds up again. Also says what the chance of a false alarm in a class is composed of.
Exit codes: 0 all are told apart, 1 not, and nothing is frozen, 2 usage, or a corpus that is not as
it must be, 4 the sandbox is weaker than the rubric asks for, 5 our own failure, 75 interrupted.

Examples:
  norigrade calibrate my-rubric.toml --only wrong/
  norigrade calibrate my-rubric.toml --seeds 3 --freeze)";

} // namespace

Language languageOf(const std::string &code) {
    std::string wanted = code;
    for (const char *name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
        const char *value = std::getenv(name);
        if (wanted == "auto" && value != nullptr && *value != '\0')
            wanted = value;
    }
    return wanted.rfind("es", 0) == 0 ? Language::Spanish : Language::English;
}

const CLI::App *addCalibrate(CLI::App &program, CalibrateCommand &command) {
    constexpr int kMostSeeds = 1000;
    constexpr int kLargestClass = 100'000;
    CLI::App *verb = program.add_subcommand(
        "calibrate", "Try a rubric on hand-ins whose mistakes are known, before it is used");
    verb->add_option("RUBRIC", command.rubric, "TOML file")->required()->type_name("");
    verb->add_option("--corpus", command.corpus,
                     "Folder with submissions/, mutants/ and variants/ (default: tests/ of the "
                     "source tree that the program was built from)")
        ->type_name("DIR");
    CLI::Option *only =
        verb->add_option("--only", command.only,
                         "Only hand-ins with this text in their name: for a look at a part")
            ->type_name("TEXT");
    verb->add_option("--seeds", command.seeds,
                     "Random numbers that each is graded with (default: 1)")
        ->type_name("N")
        ->check(CLI::Range(1, kMostSeeds));
    verb->add_option("--jobs", command.jobs, "Processes at the same time (default: one per core)")
        ->type_name("N")
        ->check(CLI::Range(1, kMostJobs));
    verb->add_option("--class-size", command.classSize,
                     "Hand-ins that the bound on false alarms is for (default: 300)")
        ->type_name("N")
        ->check(CLI::Range(1, kLargestClass));
    CLI::Option *bound =
        verb->add_flag("--bound", command.boundOnly, "Only print that bound, and grade nothing");
    verb->add_flag("--freeze", command.freeze,
                   "If all is well, write RUBRIC.frozen, which `grade` compares with the rubric")
        ->excludes(bound)
        ->excludes(only);
    verb->footer(kCalibrateExamples);
    return verb;
}

} // namespace grader
