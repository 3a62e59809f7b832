// SPDX-License-Identifier: MIT
#pragma once

#include <grader/diagnosis/catalogue.h>

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace grader {

/// `grade`, and `check`, which runs the same tests and gives no marks.
struct GradeCommand {
    bool marked = true;
    std::vector<std::filesystem::path> paths;
    std::filesystem::path rubric;   ///< empty: the assignment's own
    std::filesystem::path scenes;   ///< what figures show; empty: our own scenes
    std::filesystem::path out;      ///< empty: a new folder for `grade`, nothing for `check`
    std::string seed;               ///< 32 lower-case hexadecimal digits; empty: a fresh one
    std::vector<std::string> items; ///< rubric item ids; empty: all
    int jobs = 1;
    Language language = Language::English; ///< of diagnoses and hints
    bool json = false;
    bool quiet = false;
};

/// Tries a rubric on hand-ins whose mistakes are known.
struct CalibrateCommand {
    std::filesystem::path rubric;
    std::filesystem::path corpus; ///< folder with submissions/, mutants/, variants/; empty: ours
    std::string only;             ///< part of a hand-in's name; empty: all
    int seeds = 1;
    int jobs = 1;
    int classSize = 300;
    bool boundOnly = false; ///< grade nothing
    bool freeze = false;
};

struct DoctorCommand {};

struct LintCommand {
    std::filesystem::path rubric;
};

struct StarterCommand {
    std::filesystem::path folder;
};

/// One image against a reference.
struct CompareCommand {
    std::filesystem::path image;
    std::vector<std::filesystem::path> references; ///< one, or two independent halves
    double level = 1e-4;                           ///< family-wise significance
    double referenceSpp = 0;                       ///< 0: what the reference's header says
    std::filesystem::path tiles;                   ///< PNG to write; empty: none
    bool json = false;
};

/// Renders the references of the assignment's scenes, or verifies them.
struct ReferencesCommand {
    std::vector<std::string> scenes; ///< below the folder of scenes; empty: all
    std::filesystem::path out;       ///< empty: the project's own
    bool fullSize = false;
    bool verify = false;
};

/// How fast renders of scenes converge.
struct ConvergeCommand {
    std::vector<std::filesystem::path> scenes;
    std::vector<std::string> integrators; ///< empty: each scene's own
    std::vector<int> samples{1, 4, 16, 64};
    int replicates = 8;
    int width = 160;
    std::vector<std::filesystem::path> references; ///< none, or two independent halves
    std::filesystem::path against;                 ///< hand-in to measure beside ours; empty: none
    std::filesystem::path out = "norigrade-convergence";
    std::string seed = "1"; ///< the same one, so that a second call goes on
    bool json = false;
};

/// `--help` and `--version`: nothing to do but to print it.
struct PrintCommand {
    std::string text;
};

/// The command line cannot be followed.
struct UsageMistake {
    std::string message;
};

using Command =
    std::variant<GradeCommand, CalibrateCommand, DoctorCommand, LintCommand, StarterCommand,
                 CompareCommand, ConvergeCommand, ReferencesCommand, PrintCommand, UsageMistake>;

/// \param arguments  without the program's name
Command parseCommandLine(const std::vector<std::string> &arguments);

/// 128 fresh random bits as 32 hexadecimal digits.
/// \throws GraderError  if the system has none
std::string freshSeed();

} // namespace grader
