// SPDX-License-Identifier: MIT
#pragma once

#include <grader/diagnosis/guess.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

/// What a grading run found: plain values, from which every report is made.
namespace grader {

enum class Verdict {
    Pass,         ///< right within the stated tolerance
    Fail,         ///< wrong, confirmed
    Inconclusive, ///< the data cannot tell; see the minimal detectable error
    Missing,      ///< not handed in, or still throws "not implemented"
    BuildError,   ///< does not compile or link
    Crash,        ///< ended by a signal, exit or a broken answer
    Timeout,      ///< used up its CPU or wall time
    Infra,        ///< our own failure; never costs a point
    Human,        ///< someone has to look
};

/// `pass`, `build_error`, ... as in results.json.
const char *verdictName(Verdict verdict);

/// How much a defect may cost; set per check in the rubric.
enum class Severity {
    Blemish, ///< never costs a point; told as a remark
    Latent,  ///< costs at most the fraction of the item that the rubric sets
    Visible, ///< costs by effect
};

/// `blemish`, `latent`, `visible`.
const char *severityName(Severity severity);

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// How many points of a warp are in each cell of the map of its domain: what a check has seen.
struct PointMap {
    std::string warp;                  ///< id in the catalogue, `triangle`
    double parameter = 0;              ///< of the warp; 0 where it has none
    std::size_t points = 0;            ///< independent ones, those in no cell among them
    std::vector<std::uint32_t> counts; ///< shape [32, 32], row 0 at the map's lower edge
};

/// The outcome of one check. Numbers that do not apply are NaN (null in JSON).
struct CheckResult {
    std::string id; ///< e.g. `warp.triangle.pdf`
    Verdict verdict = Verdict::Infra;
    double effect = kNoNumber; ///< size of the deviation, relative unless `message` says otherwise
    double mde = kNoNumber;    ///< minimal detectable effect at the check's level and power
    double floor = kNoNumber;  ///< effect that every seed finds; a smaller one costs nothing
    double p = kNoNumber;      ///< of the last stage that was run
    std::string message;       ///< one sentence: what was measured and found
    std::string diagnosis;     ///< the first of `diagnoses` in a sentence; empty when there is none
    std::vector<Guess> diagnoses;          ///< likely mistakes, see bestGuesses()
    std::optional<PointMap> map;           ///< of points that are wrong, or may be
    Severity severity = Severity::Visible; ///< filled in by scoring from the rubric
    double score = 1;    ///< fraction of the check's weight that is kept [0, 1]; by scoring
    std::string variant; ///< which parts were the student's, e.g. `student` or `reference warp`
    /// Whether Emitter::sample divides by the density, where the check has seen it; not written
    /// out.
    std::optional<bool> sampleDivides;
};

struct ItemResult {
    std::string id;
    std::string title;
    double points = 0; ///< kept
    double max = 0;
    bool extra = false;
    Verdict verdict = Verdict::Infra;
    std::string reason;           ///< one line: why points were lost, or what stands
    std::vector<Guess> diagnoses; ///< the best of the checks that cost
    std::vector<CheckResult> checks;
};

/// Something a person should know about a hand-in; it never costs a point by itself.
struct Note {
    enum class Level { Info, Odd, Human }; ///< levelName(): `info`, `odd`, `human`
    Level level = Level::Info;
    std::string file; ///< as in the hand-in; may be empty
    std::string text;
};

const char *levelName(Note::Level level);

/// What a file of the hand-in was used for.
struct FileUse {
    std::string path;   ///< as in the hand-in
    std::string use;    ///< `source`, `extra`, `header`, `readme`, `figure`, `ignored`
    std::string reason; ///< why
};

/// What a figure of a hand-in turned out to be, compared with what its own code renders.
enum class FigureVerdict {
    Match,
    DifferentNoise,  ///< the same picture with more or less noise than its samples make
    DifferentValues, ///< the same picture in other brightnesses, or with differences in parts
    DifferentScene,
    Clamped,     ///< bright parts are cut off, where an EXR file holds them
    CannotTell,  ///< compared without a result, or not comparable; `message` says why
    NotCompared, ///< of no scene: a picture of a warp's test, an extra
    Missing,     ///< asked for by the handout, and not there
    Unreadable,
};

/// `match`, `different_noise`, ... as in results.json.
const char *figureVerdictName(FigureVerdict verdict);

/// Evidence for people about one figure; it never costs a point.
struct FigureResult {
    std::string path; ///< as in the hand-in; of a missing one, its name in the handout
    FigureVerdict verdict = FigureVerdict::NotCompared;
    bool flag = false;        ///< staff should look at it
    std::string scene;        ///< that it was compared with, `cbox_ems`; may be empty
    int samples = 0;          ///< per pixel, as it says; 0: it does not
    double error = kNoNumber; ///< relative deviation of its mean
    double mde = kNoNumber;   ///< of all its parts, that would be found
    double noise = kNoNumber; ///< variance of its pixels over that of the code's renders
    double p = kNoNumber;     ///< the smallest one, of the tests together
    std::string message;      ///< what was found, and how sure that is
};

/// Seconds of wall clock, by phase.
struct Timing {
    double ingest = 0, compile = 0, link = 0, sample = 0, judge = 0, figures = 0, total = 0;
};

struct SubmissionResult {
    std::string name;                 ///< of the zip or folder, without `.zip`
    std::vector<std::string> members; ///< NIPs from the name
    double total = 0;
    double cap = 0;
    bool marked = true;        ///< false for `check`: no points are shown
    std::string sandbox;       ///< level, `S3`
    std::string seed;          ///< 32 hexadecimal digits
    std::size_t hintSteps = 1; ///< of every hint ladder, as the rubric allows
    std::vector<ItemResult> items;
    std::vector<Note> notes;
    std::vector<FileUse> files;
    std::vector<FigureResult> figures; ///< in the order of their paths, missing ones last
    Timing timing;
};

/// What all marks of a run rest on.
struct Provenance {
    std::string toolVersion;
    std::string rubricId;
    std::string rubricDigest; ///< SHA-256 of the rubric's file
    std::string baseDigest;   ///< SHA-256 of the code that hand-ins are laid over
    std::string compiler;     ///< first line of `g++ --version`
};

/// One run of the grader.
struct RunResult {
    Provenance provenance;
    std::vector<SubmissionResult> submissions;
};

/// True if someone has to look at it: a check says so or, where marks are given, a note.
bool needsHuman(const SubmissionResult &result);

/// True if a part could not be tested through our own fault: the marks are not final.
bool hasInfraFailure(const SubmissionResult &result);

} // namespace grader
