// SPDX-License-Identifier: MIT
#include "box_context.h"

#include <grader/digest.h>
#include <grader/engine/engine.h>

#include <fmt/core.h>

#include <utility>

namespace grader {

namespace {

/// A check asks for a few seconds of a correct program's time at most.
constexpr BoxLimits kProbeLimits = {.cpu = std::chrono::seconds(20),
                                    .wall = std::chrono::seconds(90),
                                    .memoryBytes = std::uint64_t{3} << 30,
                                    .fileBytes = std::uint64_t{64} << 20,
                                    .logBytes = std::uint64_t{1} << 20,
                                    .processes = 32};

} // namespace

BoxContext::BoxContext(const Sandbox &sandbox, const std::atomic<bool> *interrupted,
                       std::filesystem::path student, std::filesystem::path reference,
                       ReferenceAnswers &known, std::string seedText, std::string digest)
    : m_sandbox(sandbox),
      m_interrupted(interrupted),
      m_student(std::move(student)),
      m_reference(std::move(reference)),
      m_known(known),
      m_seedText(std::move(seedText)),
      m_digest(std::move(digest)) {}

ProbeAnswer BoxContext::ask(const protocol::RequestGroup &group) {
    return askOne(m_student, group);
}

ProbeAnswer BoxContext::askReference(const protocol::RequestGroup &group) {
    stopIfInterrupted();
    if (const ProbeAnswer *answer = m_known.find(group))
        return *answer;
    ProbeAnswer answer = askOne(m_reference, group);
    m_known.keep(group, answer);
    return answer;
}

std::uint64_t BoxContext::seed(std::string_view purpose, int stage, int replicate) const {
    const std::string text = fmt::format("{}|{}|{}|{}|{}", m_seedText, purpose, stage, replicate,
                                         stage > 0 ? m_digest : "");
    return std::stoull(sha256Hex(text).substr(0, 16), nullptr, 16);
}

void BoxContext::stopIfInterrupted() const {
    if (m_interrupted != nullptr && *m_interrupted)
        throw Interrupted();
}

ProbeAnswer BoxContext::askOne(const std::filesystem::path &probe,
                               const protocol::RequestGroup &group) {
    stopIfInterrupted();
    ProbeAnswer answer = askProbe(m_sandbox, probe, group, kProbeLimits);
    m_sampleSeconds += answer.outcome.wallSeconds;
    return answer;
}

} // namespace grader
