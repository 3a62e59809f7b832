// SPDX-License-Identifier: MIT
#pragma once

#include <battery/callables.h>
#include <battery/consistency.h>
#include <battery/density.h>
#include <battery/distribution.h>
#include <battery/inputs.h>
#include <battery/nearest_mistake.h>
#include <battery/range.h>
#include <battery/stratified.h>
#include <battery/tabulated_target.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

/// Runs everything in this folder on a warp and its density, in the order in which a mistake is
/// best explained:
///
///     auto result = battery::testWarp(myWarp, myDensity, catalog::requireWarp("disk"));
///     EXPECT_TRUE(result.passed()) << result;
///
/// A target of one's own is a density in a chart: tabulateTarget("lobe", catalog::zone(0, 1), f).
namespace battery {

enum class Status { Pass, Fail, Inconclusive, NotRun };

/// "✔ pass", "✖ fail", "▲ cannot tell", "○ not run": never told by a colour alone.
const char *label(Status status);
/// "pass", "fail", "inconclusive", "not run", for files.
const char *word(Status status);

struct TestOptions {
    double parameter = 0.0;     ///< of the target; 0: the first of its `parameters`
    std::uint64_t seed = 1;     ///< equal seeds give equal results
    int repeats = 1;            ///< whole tests on fresh random numbers; every one must pass
    double significance = 1e-4; ///< of stages 1 and 2 of the triple lock; a tenth of it of stage 3
    std::size_t samples = kDistributionSamples; ///< of stage 1; stages 2 and 3 take 4 and 16 times
    std::function<void(double fraction)> progress; ///< called between steps; may be empty
    std::function<bool()> isCancelled;             ///< asked between steps; may be empty
};

/// One step of the battery, in words.
struct TestRow {
    std::string id;   ///< "normalisation": for programs
    std::string name; ///< "∫ pdf": for people
    std::string value;
    std::string expected;
    Status status = Status::NotRun;
};

struct TestResult {
    Status verdict = Status::NotRun; ///< NotRun after a cancellation
    std::string headline;            ///< one line
    std::vector<TestRow> rows;
    std::vector<std::string> remarks; ///< what is wrong, and what it may mean
    std::string power;                ///< what would have been found, and what is left possible
    std::string error;                ///< what the warp or the density threw; empty: nothing
    bool isStub = false;              ///< the error says that it is not implemented
    std::vector<Status> repeats;      ///< verdicts; the rest is of the first with the worst one

    /// Of the first stage's 32x32 histogram, of each repeat, against the exact density without any
    /// tolerance: uniform in [0, 1] for a right warp. For a plot, never for a verdict.
    std::vector<double> seedPValues;

    double parameter = 0.0;
    RangeResult range; ///< of a grid and of random inputs together
    RangeResult edges; ///< of edgeInputs(): a remark
    DuplicateResult duplicates;
    DensityResult density;
    double integral = 0.0; ///< of the density over its support and what is outside
    StratifiedResult stratified;
    DistributionResult distribution; ///< of the last stage: counts and deviations for a map
    std::size_t stages = 0;          ///< of the triple lock that were needed
    std::size_t points = 0;          ///< independent ones, of all stages
    ConsistencyResult consistency;   ///< a diagnosis, never a verdict
    ImportanceCheck importance;      ///< of testOwnDensity() alone
    MistakeMatch mistake;            ///< the warp's, if it is wrong and looks like a known one

    [[nodiscard]] bool passed() const { return verdict == Status::Pass; }
};

/// Judges a warp and its density: domain and repeatability, density point by point, integral,
/// smooth moments of stratified points, distribution (triple lock), whether the two agree, and the
/// nearest known mistake. What they throw, or an answer of the wrong shape, is a failure with its
/// `error`.
/// \throws std::invalid_argument  for options that make no test (no samples, no repeats, a
///                                significance outside of (0, 0.1])
TestResult testWarp(const Warp &warp, const Density &density, const catalog::WarpEntry &target,
                    const TestOptions &options = {});

/// Judges whether a warp samples the density that comes with it, where no other truth is known (a
/// BSDF, an environment map): the density is tabulated in a chart and takes the target's place.
/// Right only in that they agree and integrate to 1. Inconclusive where the density cannot be
/// integrated well enough: two rules differ, or the samples see what the table does not.
/// \throws std::invalid_argument  as testWarp()
TestResult testOwnDensity(const Warp &warp, const Density &density, const catalog::Chart &chart,
                          const TestOptions &options = {});

/// A warp with a parameter, and its density.
struct WarpFamily {
    std::function<std::vector<Output>(std::span<const Input>, double a)> warp;
    std::function<std::vector<float>(std::span<const Output>, double a)> density;
};

/// The test at every parameter of the target: one alone hides mistakes (at alpha = 1 it does not
/// matter that alpha is not squared).
/// \return  one result for each of `target.parameters`, fewer after a cancellation
std::vector<TestResult> testEveryParameter(const WarpFamily &family,
                                           const catalog::WarpEntry &target,
                                           const TestOptions &options = {});

/// Everything that a result says, as lines of text.
std::string explain(const TestResult &result);
std::ostream &operator<<(std::ostream &stream, const TestResult &result);

} // namespace battery
