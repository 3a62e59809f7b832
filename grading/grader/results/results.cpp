// SPDX-License-Identifier: MIT
#include "results.h"

#include <algorithm>

namespace grader {

const char *verdictName(Verdict verdict) {
    switch (verdict) {
    case Verdict::Pass:
        return "pass";
    case Verdict::Fail:
        return "fail";
    case Verdict::Inconclusive:
        return "inconclusive";
    case Verdict::Missing:
        return "missing";
    case Verdict::BuildError:
        return "build_error";
    case Verdict::Crash:
        return "crash";
    case Verdict::Timeout:
        return "timeout";
    case Verdict::Human:
        return "human";
    case Verdict::Infra:
        break;
    }
    return "infra";
}

const char *severityName(Severity severity) {
    switch (severity) {
    case Severity::Blemish:
        return "blemish";
    case Severity::Latent:
        return "latent";
    case Severity::Visible:
        break;
    }
    return "visible";
}

const char *levelName(Note::Level level) {
    switch (level) {
    case Note::Level::Info:
        return "info";
    case Note::Level::Odd:
        return "odd";
    case Note::Level::Human:
        break;
    }
    return "human";
}

const char *figureVerdictName(FigureVerdict verdict) {
    switch (verdict) {
    case FigureVerdict::Match:
        return "match";
    case FigureVerdict::DifferentNoise:
        return "different_noise";
    case FigureVerdict::DifferentValues:
        return "different_values";
    case FigureVerdict::DifferentScene:
        return "different_scene";
    case FigureVerdict::Clamped:
        return "clamped";
    case FigureVerdict::CannotTell:
        return "cannot_tell";
    case FigureVerdict::Missing:
        return "missing";
    case FigureVerdict::Unreadable:
        return "unreadable";
    case FigureVerdict::NotCompared:
        break;
    }
    return "not_compared";
}

namespace {

bool anyVerdict(const SubmissionResult &result, Verdict verdict) {
    return std::any_of(result.items.begin(), result.items.end(), [=](const ItemResult &item) {
        return item.verdict == verdict ||
               std::any_of(item.checks.begin(), item.checks.end(),
                           [=](const CheckResult &check) { return check.verdict == verdict; });
    });
}

} // namespace

bool needsHuman(const SubmissionResult &result) {
    // Whose a hand-in is, and which of two files counts, is nothing to ask of one's own work.
    return anyVerdict(result, Verdict::Human) ||
           (result.marked &&
            std::any_of(result.notes.begin(), result.notes.end(),
                        [](const Note &note) { return note.level == Note::Level::Human; }));
}

bool hasInfraFailure(const SubmissionResult &result) {
    return anyVerdict(result, Verdict::Infra);
}

} // namespace grader
