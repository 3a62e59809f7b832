// SPDX-License-Identifier: MIT
#pragma once

#include <grader/build/variant_builder.h>
#include <grader/checks/check.h>
#include <grader/error.h>
#include <grader/figures/figure_scenes.h>
#include <grader/results/results.h>
#include <grader/rubric/rubric.h>
#include <grader/submission/submission.h>

#include <atomic>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace grader {

struct EngineOptions {
    std::string seedHex;            ///< of the run; same seed, same numbers, whatever `jobs` is
    int jobs = 2;                   ///< boxes that run at the same time
    const Rubric *rubric = nullptr; ///< with its checks resolved
    const Rubric *asked = nullptr;  ///< the part of it that is graded: see withItems()
    const FigureScenes *scenes = nullptr; ///< what figures show; null: figures are not compared
    const std::atomic<bool> *interrupted = nullptr; ///< polled between boxes; may be null
};

/// The machine gives less than the rubric asks for; the message says how to mend it.
class SandboxTooWeak : public GraderError {
public:
    using GraderError::GraderError;
};

/// What `interrupted` turns into.
class Interrupted : public std::runtime_error {
public:
    Interrupted() : std::runtime_error("interrupted") {}
};

using ProgressCallback = std::function<void(std::string_view phase, double fraction)>;

/// Grades hand-ins: builds their variants, runs the checks that the rubric asks for in the order of
/// the groups, and follows a failure through to whose it is. Starts every process that is started.
class Engine {
public:
    /// \throws SandboxTooWeak  below the rubric's `min_sandbox`
    Engine(const Sandbox &sandbox, const EngineOptions &options);

    /// \throws GraderError  when we fail, Interrupted; never for what a submission does
    SubmissionResult grade(const Submission &submission, const ProgressCallback &progress);

private:
    /// The results of all checks that are asked for, and where one of them fails, of what they
    /// stand on: that may be at fault.
    std::vector<CheckResult> runChecks(VariantBuilder &builder, const Submission &submission,
                                       const ProgressCallback &progress, double &sampleSeconds);
    void compareFigures(const Submission &submission, VariantBuilder &builder,
                        const ProgressCallback &progress, SubmissionResult &result) const;

    const Sandbox &m_sandbox;
    EngineOptions m_options;
    Cache m_cache;
    std::filesystem::path m_referenceProbe;
};

} // namespace grader
