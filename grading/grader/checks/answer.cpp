// SPDX-License-Identifier: MIT
#include "answer.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>

namespace grader {

namespace {

/// How stubs say that they are stubs: the starter's own words, and what students turn them into.
constexpr const char *kStubWords[] = {"not yet implemented", "not implemented", "unimplemented",
                                      "no implementad", "sin implementar"};

bool saysUnimplemented(std::string message) {
    std::transform(message.begin(), message.end(), message.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return std::any_of(std::begin(kStubWords), std::end(kStubWords),
                       [&](const char *words) { return message.find(words) != std::string::npos; });
}

Verdict verdictOf(const BoxEnd &end) {
    if (!ownFailure(end).empty())
        return Verdict::Infra;
    return std::holds_alternative<BoxTimedOut>(end) ? Verdict::Timeout : Verdict::Crash;
}

} // namespace

CheckResult makeResult(Verdict verdict, std::string message, std::vector<Guess> diagnoses) {
    CheckResult result;
    result.verdict = verdict;
    result.message = std::move(message);
    result.diagnoses = std::move(diagnoses);
    return result;
}

std::vector<Guess> explain(const statistics::LockResult &lock, std::vector<Guess> guesses,
                           const char *diagnosis) {
    if (lock.decision == statistics::Decision::Fail && !lock.sameDeviation)
        guesses.insert(guesses.begin(), {diagnosis, 1});
    return guesses;
}

std::optional<CheckResult> unanswered(const ProbeAnswer &answer) {
    if (answer.complete())
        return std::nullopt;
    for (const protocol::Response &response : answer.responses) {
        if (response.state != protocol::State::Threw)
            continue;
        const bool isStub = saysUnimplemented(response.message);
        return makeResult(isStub ? Verdict::Missing : Verdict::Fail,
                          fmt::format("The code throws: {}", response.message));
    }
    const bool exited = std::holds_alternative<BoxExited>(answer.outcome.end);
    return makeResult(
        verdictOf(answer.outcome.end),
        exited ? "The program ended without an answer (exit() or an uncaught "
                 "exception?)."
               : fmt::format("The program did not answer: {}.", describe(answer.outcome.end)));
}

} // namespace grader
