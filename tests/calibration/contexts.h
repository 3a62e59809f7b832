// SPDX-License-Identifier: MIT
#pragma once

#include <grader/checks/check.h>
#include <probe/probe.h>

#include <optional>
#include <set>

#include "recording.h"
#include "work_folder.h"

namespace calibration {

/// What a check asks is answered in this process. Knows which stages were begun: each but the first
/// begins only when the one before it has rejected.
class LocalContext : public grader::CheckContext {
public:
    explicit LocalContext(std::uint64_t seed) : m_seed(seed) {}

    std::uint64_t seed(std::string_view purpose, int stage, int replicate) const override;

    bool hasBegun(int stage) const { return m_stages.count(stage) != 0; }

private:
    std::uint64_t m_seed;
    mutable std::set<int> m_stages;
};

/// Questions about images, answered with recorded samples. Which pixels' samples is all that a
/// question tells: its scene must be that of the recording.
class RecordedContext : public LocalContext {
public:
    RecordedContext(const Recording &student, const Recording &ours, std::uint64_t seed)
        : LocalContext(seed), m_student(student), m_ours(ours) {}

    grader::ProbeAnswer ask(const protocol::RequestGroup &group) override;
    grader::ProbeAnswer askReference(const protocol::RequestGroup &group) override;

private:
    const Recording &m_student;
    const Recording &m_ours;
};

/// The scene that was asked about last stays loaded; those before it are never freed (SceneStore).
class LoadedScenes {
public:
    /// With Integrator::preprocess() called.
    /// \throws whatever loading throws
    nori::Scene &get(const protocol::RequestGroup &group, const std::string &name);

private:
    std::vector<protocol::File> m_files;
    std::optional<WorkFolder> m_folder;
    std::optional<probe::SceneStore> m_scenes;
};

/// Questions about points of meshes, emitters and the radiance along rays, answered by our own
/// renderer.
class OwnContext : public LocalContext {
public:
    /// \param sceneSeed  decides the scene instead of `seed`
    /// \param isTwin     every twentieth sample is the first one again, and radiance is too bright,
    ///                   which is wrong
    OwnContext(LoadedScenes &scenes, std::uint64_t sceneSeed, std::uint64_t seed, bool isTwin)
        : LocalContext(seed), m_scenes(scenes), m_sceneSeed(sceneSeed), m_isTwin(isTwin) {}

    std::uint64_t seed(std::string_view purpose, int stage, int replicate) const override;
    /// \throws std::invalid_argument  if it is about something else
    grader::ProbeAnswer ask(const protocol::RequestGroup &group) override;
    grader::ProbeAnswer askReference(const protocol::RequestGroup &group) override;

private:
    grader::ProbeAnswer answer(const protocol::RequestGroup &group, bool isWrong);

    LoadedScenes &m_scenes;
    std::uint64_t m_sceneSeed;
    bool m_isTwin;
};

} // namespace calibration
