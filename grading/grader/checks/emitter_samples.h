// SPDX-License-Identifier: MIT
#pragma once

#include <grader/checks/check.h>
#include <grader/scenes/test_scene.h>

#include <optional>
#include <string>
#include <vector>

namespace grader {

/// What Emitter::sample left in the record, and what eval and pdf say of it.
struct EmitterSampleRow {
    Vector3d ref = Vector3d::Zero();
    Vector3d value = Vector3d::Zero(); ///< returned by sample
    Vector3d p = Vector3d::Zero();
    Vector3d n = Vector3d::Zero();
    Vector2d uv = Vector2d::Zero();
    Vector3d wi = Vector3d::Zero();
    double dist = 0;
    double recordPdf = 0;             ///< NaN when sample left it unset
    double pdf = 0;                   ///< Emitter::pdf
    Vector3d eval = Vector3d::Zero(); ///< Emitter::eval
    bool emitterSet = false;
};

struct EmitterAnswer {
    std::vector<EmitterSampleRow> rows;
    std::optional<CheckResult> failure; ///< set when there is nothing to judge
};

/// What askEmitterSamples() asks.
protocol::RequestGroup emitterSampleRequest(const TestScene &scene, int emitter,
                                            const std::vector<Vector3d> &refs, std::uint64_t seed);

/// Samples an emitter from reference points, `refs` each with fresh random numbers.
EmitterAnswer askEmitterSamples(CheckContext &context, const TestScene &scene, int emitter,
                                const std::vector<Vector3d> &refs, std::uint64_t seed);

/// A place on an emitter as another integrator would give it: five-argument constructor.
struct EmitterQuery {
    Vector3d ref;
    Vector3d p;
    Vector3d n;
    Vector2d uv;
};

struct EmitterEvalRow {
    Vector3d eval;
    double pdf = 0;
};

struct EvalAnswer {
    std::vector<EmitterEvalRow> rows;
    std::optional<CheckResult> failure;
};

/// \param reference  ask our own implementation instead of the student's
EvalAnswer askEmitterEval(CheckContext &context, const TestScene &scene, int emitter,
                          const std::vector<EmitterQuery> &queries, bool reference = false);

/// How Emitter::sample's value relates to eval: both readings are in use (nori2-api.md §9).
enum class SampleConvention { Value, ValueOverPdf, Either, Neither };

/// The one convention that all rows with light in them follow; Neither if they do not agree.
/// \param wrong  if not null, set to the number of rows that break the best one
SampleConvention detectConvention(const std::vector<EmitterSampleRow> &rows, int *wrong = nullptr);

/// Judges that Emitter::sample's value follows one of the conventions, and tells which.
/// \param otherwise  id of the diagnosis where no known mistake fits
CheckResult judgeSampleValue(const std::vector<EmitterSampleRow> &rows, const char *otherwise);

/// A deterministic judgement over rows: Pass if nothing is wrong, else Fail with the part of the
/// rows that is.
CheckResult judgeRows(std::size_t wrong, std::size_t total, const std::string &what,
                      std::vector<Guess> diagnoses);

} // namespace grader
