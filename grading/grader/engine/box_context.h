// SPDX-License-Identifier: MIT
#pragma once

#include <grader/checks/check.h>
#include <grader/engine/reference_answers.h>
#include <grader/prober/prober.h>

#include <atomic>
#include <filesystem>
#include <string>

namespace grader {

/// Lets a check ask a probe, each group of questions in a box of its own.
class BoxContext : public CheckContext {
public:
    /// \param interrupted  may be null; every question asks it, as checks ask many
    /// \param known        what our own program has answered to this check
    BoxContext(const Sandbox &sandbox, const std::atomic<bool> *interrupted,
               std::filesystem::path student, std::filesystem::path reference,
               ReferenceAnswers &known, std::string seedText, std::string digest);

    /// \throws Interrupted
    ProbeAnswer ask(const protocol::RequestGroup &group) override;
    /// \throws Interrupted
    ProbeAnswer askReference(const protocol::RequestGroup &group) override;

    /// The first stage is the same for every hand-in of a run, fair and reproducible; later ones
    /// are fresh for each.
    std::uint64_t seed(std::string_view purpose, int stage, int replicate) const override;

    /// Wall seconds that probes have run.
    double sampleSeconds() const { return m_sampleSeconds; }

private:
    void stopIfInterrupted() const;
    ProbeAnswer askOne(const std::filesystem::path &probe, const protocol::RequestGroup &group);

    const Sandbox &m_sandbox;
    const std::atomic<bool> *m_interrupted;
    std::filesystem::path m_student;
    std::filesystem::path m_reference;
    ReferenceAnswers &m_known;
    std::string m_seedText;
    std::string m_digest;
    double m_sampleSeconds = 0;
};

} // namespace grader
