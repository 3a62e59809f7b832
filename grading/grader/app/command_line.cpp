// SPDX-License-Identifier: MIT
#include "command_line.h"

#include <grader/error.h>
#include <grader/rubric/nearest_name.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <thread>

#include "calibrate_options.h"

namespace grader {

namespace {

constexpr std::size_t kSeedDigits = 32;

constexpr char kExitCodes[] = R"(
Exit codes: 0 done, whatever the marks are; 1 check: some tests failed; 2 wrong usage or rubric;
3 done, but someone has to look; 4 this machine cannot lock submissions in as the rubric asks;
5 something could not be tested through no fault of a hand-in; 75 interrupted, what is done is kept.)";

constexpr char kExamples[] = R"(
Examples:
  norigrade grade p2_123456_654321.zip           grade one hand-in
  norigrade grade handins/*.zip --out results    grade many, with a page for each in results/
  norigrade check my_solution/                   the same tests on your own work, without marks
  norigrade doctor                               how strongly this machine locks submissions in
  norigrade starter student_edition/             the base code to hand out)";

constexpr char kGradeExamples[] = R"(
Examples:
  norigrade grade p2_123456_654321.zip
  norigrade grade handins/*.zip --out results --jobs 8
  norigrade grade hand_in/ --rubric my_rubric.toml --seed 2a
  norigrade grade hand_in.zip --item area_light  one item, with the result it has in a whole run
  norigrade grade hand_in.zip --json | jq '.submissions[0].total')";

constexpr char kCheckExamples[] = R"(
Examples:
  norigrade check .                              the folder that holds your src/
  norigrade check p2_123456_654321.zip           what you are about to hand in
  norigrade check . --out report                 with a page to read in report/)";

constexpr char kDoctorExamples[] = R"(
Example:
  norigrade doctor)";

constexpr char kLintExamples[] = R"(
Example:
  norigrade lint my_rubric.toml)";

constexpr char kStarterExamples[] = R"(
Example:
  norigrade starter student_edition/)";

constexpr char kCompareExamples[] = R"(
Examples:
  norigrade compare cbox_ems_512.exr cbox_ems.exr --reference-spp 1024
  norigrade compare mine.exr --reference half_a.exr half_b.exr --tiles z.png
  norigrade compare a.exr b.exr --json | jq .verdict

A verdict needs moments: render with `nori --moments`, each image with a seed of its own.
Exit codes: 0 alike, 1 different, 3 cannot tell, 2 a file cannot be compared.)";

constexpr char kConvergeExamples[] = R"(
Examples:
  norigrade converge cbox_ems.xml --integrator direct_ems,direct_mats,direct_mis
  norigrade converge serapis_ems.xml serapis_ems_power.xml --spp 1,4,16,64,256 --out power
  norigrade converge cbox_ems.xml --reference a.exr b.exr --json
  norigrade converge cbox_ems.xml --against p2_123456_654321.zip --out student

The images stay in the folder of --out: a second call renders only what is missing.
Exit codes: 0 every slope is -1/2, 1 one is not, 3 cannot tell, 75 interrupted.)";

constexpr char kReferencesExamples[] = R"(
Renders what is not there yet or whose scene has changed; an interrupted call is resumed by the next.
--verify renders nothing into the folder: it renders each scene by two other algorithms (sampling the
BSDF, or the sum over point lights; both strategies) and says how far they agree. It takes as long as
the references themselves.

Examples:
  norigrade references                              what is missing in references/assignment-2/
  norigrade references cbox/cbox_ems.xml --full-size --out /tmp/full
  norigrade references --verify)";

/// The digits as 32 lower-case ones; CLI11 reports what is no seed.
std::string normalizeSeed(const std::string &seed) {
    std::string digits(kSeedDigits - seed.size(), '0');
    for (const char c : seed)
        digits += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return digits;
}

std::string requireHex(const std::string &seed) {
    const bool hex = std::all_of(seed.begin(), seed.end(),
                                 [](unsigned char c) { return std::isxdigit(c) != 0; });
    if (hex && !seed.empty() && seed.size() <= kSeedDigits)
        return {};
    return fmt::format("\"{}\" is no seed: give 1 to {} hexadecimal digits", seed, kSeedDigits);
}

CLI::App *addGrade(CLI::App &program, GradeCommand &command, bool marked) {
    CLI::App *verb =
        marked ? program.add_subcommand("grade", "Grade hand-ins: zips or folders")
               : program.add_subcommand("check", "Test your own work: the same tests, no marks");
    CLI::Option *paths = verb->add_option("PATH", command.paths,
                                          marked ? "Zips or folders, one per hand-in"
                                                 : "Zip or folder with your files");
    paths->required()->type_name("");
    if (!marked)
        paths->expected(1);
    verb->add_option("--rubric", command.rubric, "TOML file (default: the assignment's own)")
        ->type_name("FILE");
    verb->add_option("--item", command.items,
                     "Only this rubric item; may be given several times (default: all)")
        ->type_name("ID")
        ->allow_extra_args(false);
    verb->add_option("--scenes", command.scenes,
                     "Folder of the scenes that were handed out, to compare figures with (default: "
                     "norigrade's own, where a difference says little)")
        ->type_name("DIR");
    verb->add_option("--out", command.out,
                     marked ? "Folder for results.json and the pages (default: a new one below "
                              "norigrade-results/)"
                            : "Folder for results.json and a page (default: nothing is written)")
        ->type_name("DIR");
    verb->add_option("--jobs", command.jobs, "Processes at the same time (default: one per core)")
        ->type_name("N")
        ->check(CLI::Range(1, kMostJobs));
    verb->add_option("--seed", command.seed,
                     "1 to 32 hexadecimal digits: the same seed, the same results (default: fresh)")
        ->type_name("HEX")
        ->check(requireHex);
    verb->add_option_function<std::string>(
            "--lang", [&command](const std::string &code) { command.language = languageOf(code); },
            "Language of diagnoses and hints: en, es or auto (default: the locale's)")
        ->type_name("CODE")
        ->check(CLI::IsMember({"en", "es", "auto"}))
        ->default_str("auto")
        ->force_callback();
    verb->add_flag("--json", command.json, "Print results.json instead of tables");
    verb->add_flag("--quiet", command.quiet, "Print one line per hand-in, no progress");
    verb->footer(marked ? kGradeExamples : kCheckExamples);
    return verb;
}

const CLI::App *addCompare(CLI::App &program, CompareCommand &command) {
    CLI::App *verb =
        program.add_subcommand("compare", "Tell whether two renders show the same radiance");
    verb->add_option("IMAGE", command.image, "EXR or PNG file to judge")->required()->type_name("");
    // Two ways to name it: a plain pair of files reads best without an option.
    CLI::Option *second =
        verb->add_option("REFERENCE", command.references, "What it should look like")
            ->expected(1)
            ->type_name("");
    verb->add_option("--reference", command.references,
                     "Instead of REFERENCE: one file, or two independent halves of one reference")
        ->expected(1, 2)
        ->type_name("FILE")
        ->excludes(second);
    verb->add_option("--level", command.level,
                     "Chance of calling two right renders different (default: 1e-4)")
        ->type_name("P")
        ->check(CLI::Range(1e-12, 0.1));
    verb->add_option("--reference-spp", command.referenceSpp,
                     "Samples per pixel of a reference that does not say")
        ->type_name("N")
        ->check(CLI::PositiveNumber);
    verb->add_option("--tiles", command.tiles,
                     "PNG to write: where, and how significantly, they "
                     "differ")
        ->type_name("FILE");
    verb->add_flag("--json", command.json, "Print JSON with every tile");
    verb->footer(kCompareExamples);
    return verb;
}

const CLI::App *addConverge(CLI::App &program, ConvergeCommand &command) {
    constexpr int kMostReplicates = 1000;
    constexpr int kMostSamples = 1 << 20;
    constexpr int kWidest = 10'000;
    CLI::App *verb = program.add_subcommand(
        "converge", "Measure how the error of renders falls, and what a sample costs");
    verb->add_option("SCENE", command.scenes, "Scene files")->required()->type_name("");
    verb->add_option("--integrator", command.integrators,
                     "Integrators, with commas between (default: each scene's own)")
        ->delimiter(',')
        ->type_name("NAME");
    verb->add_option("--spp", command.samples, "Samples per pixel (default: 1,4,16,64)")
        ->delimiter(',')
        ->type_name("N")
        ->check(CLI::Range(1, kMostSamples));
    verb->add_option("--replicates", command.replicates, "Independent renders of each (default: 8)")
        ->type_name("K")
        ->check(CLI::Range(2, kMostReplicates));
    verb->add_option("--width", command.width, "Of the images, in pixels (default: 160)")
        ->type_name("N")
        ->check(CLI::Range(1, kWidest));
    verb->add_option("--reference", command.references,
                     "Two independent halves of the scene's reference (default: rendered here, "
                     "with 4 times the most samples)")
        ->expected(2)
        ->type_name("FILE");
    verb->add_option("--against", command.against,
                     "Zip or folder with a hand-in, whose code renders the scenes as well, in the "
                     "sandbox and with each scene's own integrator")
        ->type_name("SUBMISSION");
    verb->add_option("--out", command.out,
                     "Folder for images, table and plots (default: norigrade-convergence)")
        ->type_name("DIR");
    verb->add_option("--seed", command.seed, "Other digits, other random numbers (default: 1)")
        ->type_name("HEX")
        ->check(requireHex);
    verb->add_flag("--json", command.json, "Print convergence.json instead of the table");
    verb->footer(kConvergeExamples);
    return verb;
}

const CLI::App *addReferences(CLI::App &program, ReferencesCommand &command) {
    CLI::App *verb = program.add_subcommand(
        "references", "Render reference images of the assignment's scenes, or verify them");
    verb->add_option("SCENE", command.scenes,
                     "Below scenes/assignment-2, such as cbox/cbox_ems.xml (default: all)")
        ->type_name("");
    verb->add_option("--out", command.out,
                     "Folder of the images and manifest.toml (default: references/assignment-2)")
        ->type_name("DIR");
    verb->add_flag("--full-size", command.fullSize,
                   "In the scenes' own sizes, not 256 pixels wide; needs --out");
    verb->add_flag("--verify", command.verify, "Compare them with renders by other algorithms");
    verb->footer(kReferencesExamples);
    return verb;
}

void addDoctor(CLI::App &program) {
    program.add_subcommand("doctor", "Say which sandbox level this machine gives, and why")
        ->footer(kDoctorExamples);
}

const CLI::App *addLint(CLI::App &program, LintCommand &command) {
    CLI::App *verb = program.add_subcommand("lint", "Check a rubric and say how it adds up");
    verb->add_option("RUBRIC", command.rubric, "TOML file")->required()->type_name("");
    verb->footer(kLintExamples);
    return verb;
}

const CLI::App *addStarter(CLI::App &program, StarterCommand &command) {
    CLI::App *verb = program.add_subcommand(
        "starter", "Write the student edition: the base code without the graded parts");
    verb->add_option("DIR", command.folder, "Folder to make; must be new or empty")
        ->required()
        ->type_name("");
    verb->footer(kStarterExamples);
    return verb;
}

/// What CLI11 cannot ask for.
Command checked(const CompareCommand &command) {
    if (command.references.empty())
        return UsageMistake{"compare needs a second image, the reference\n"
                            "norigrade compare --help tells more"};
    return command;
}

Command checked(const ReferencesCommand &command) {
    if (command.fullSize && command.out.empty())
        return UsageMistake{"--full-size needs --out DIR: the project's own folder holds small "
                            "images\nnorigrade references --help tells more"};
    return command;
}

/// CLI11's own message, with the option that was probably meant.
std::string explain(const CLI::ParseError &error, const CLI::App &program,
                    const std::vector<std::string> &arguments) {
    std::string message = error.what();
    const std::vector<CLI::App *> chosen = program.get_subcommands();
    const CLI::App &app = chosen.empty() ? program : *chosen.front();
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError)) {
        std::vector<std::string> known;
        for (const CLI::Option *option : app.get_options()) {
            for (const std::string &name : option->get_lnames())
                known.push_back("--" + name);
        }
        for (const std::string &argument : arguments) {
            const std::string name = argument.substr(0, argument.find('='));
            if (name.rfind("--", 0) != 0 ||
                std::find(known.begin(), known.end(), name) != known.end())
                continue;
            message = fmt::format("there is no option {}{}", name, suggestion(name, known));
            break;
        }
    }
    const std::string verb = chosen.empty() ? "" : " " + app.get_name();
    return fmt::format("{}\nnorigrade{} --help tells more", message, verb);
}

} // namespace

Command parseCommandLine(const std::vector<std::string> &arguments) {
    CLI::App program(
        "Grades hand-ins of a Nori 2 assignment: builds them in a sandbox, tests every "
        "rubric item, and says why a point is lost.",
        "norigrade");
    program.require_subcommand(1);
    program.set_version_flag("--version", "norigrade " NORI_VERSION);
    program.footer(std::string(kExamples) + "\n" + kExitCodes);

    const int cores = static_cast<int>(
        std::clamp(std::thread::hardware_concurrency(), 1u, static_cast<unsigned>(kMostJobs)));
    GradeCommand grade;
    GradeCommand check;
    grade.jobs = check.jobs = cores;
    check.marked = false;
    const CLI::App *gradeVerb = addGrade(program, grade, true);
    const CLI::App *checkVerb = addGrade(program, check, false);

    addDoctor(program);
    LintCommand lint;
    const CLI::App *lintVerb = addLint(program, lint);

    CalibrateCommand calibrate;
    calibrate.jobs = cores;
    const CLI::App *calibrateVerb = addCalibrate(program, calibrate);

    StarterCommand starter;
    const CLI::App *starterVerb = addStarter(program, starter);

    CompareCommand compare;
    const CLI::App *compareVerb = addCompare(program, compare);
    ConvergeCommand converge;
    const CLI::App *convergeVerb = addConverge(program, converge);
    ReferencesCommand references;
    const CLI::App *referencesVerb = addReferences(program, references);

    if (arguments.empty())
        return PrintCommand{program.help()};
    if (arguments.front().rfind('-', 0) != 0) {
        std::vector<std::string> verbs;
        for (const CLI::App *verb : program.get_subcommands({}))
            verbs.push_back(verb->get_name());
        if (std::find(verbs.begin(), verbs.end(), arguments.front()) == verbs.end())
            return UsageMistake{fmt::format("there is no verb \"{}\"{}", arguments.front(),
                                            suggestion(arguments.front(), verbs))};
    }
    try {
        program.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::CallForHelp &) {
        return PrintCommand{program.help()};
    } catch (const CLI::CallForVersion &error) {
        return PrintCommand{std::string(error.what()) + "\n"};
    } catch (const CLI::ParseError &error) {
        return UsageMistake{explain(error, program, arguments)};
    }
    for (GradeCommand *command : {&grade, &check}) {
        if (!command->seed.empty())
            command->seed = normalizeSeed(command->seed);
    }
    if (gradeVerb->parsed())
        return grade;
    if (checkVerb->parsed())
        return check;
    if (calibrateVerb->parsed())
        return calibrate;
    if (lintVerb->parsed())
        return lint;
    if (starterVerb->parsed())
        return starter;
    if (convergeVerb->parsed())
        return converge;
    if (compareVerb->parsed())
        return checked(compare);
    if (referencesVerb->parsed())
        return checked(references);
    return DoctorCommand{};
}

std::string freshSeed() {
    std::array<unsigned char, kSeedDigits / 2> bytes{};
    if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
        throw GraderError("the system gives no random numbers (getrandom)");
    return fmt::format("{:02x}", fmt::join(bytes, ""));
}

} // namespace grader
