// SPDX-License-Identifier: MIT
#pragma once

#include <grader/references/render_process.h>
#include <grader/sandbox/box.h>
#include <protocol/image.h>

#include <atomic>
#include <filesystem>
#include <string>

namespace grader {

/// Renders scenes with a hand-in's own code, in the box.
class HandInRenderer {
public:
    /// Reads and builds the hand-in.
    /// \throws GraderError  if it cannot be read, or its integrator cannot be built, with the
    /// reason
    HandInRenderer(const Sandbox &sandbox, const std::filesystem::path &handIn, int jobs);

    const std::string &name() const { return m_name; }

    const std::string &digest() const { return m_digest; }

    /// Renders with the scene's own integrator and box pixels, whatever the job names, into a file
    /// for readPlanes(). Moments are computed here from the raw samples.
    /// \throws GraderError  if the hand-in's code gives no image
    RenderEnd render(const RenderJob &job, const std::atomic<bool> &interrupted) const;

private:
    const Sandbox &m_sandbox;
    std::string m_name;
    std::string m_digest;
    std::filesystem::path m_executable;
};

/// Extension of the files that HandInRenderer writes.
inline constexpr char kPlanesExtension[] = ".planes";

/// \throws GraderError  naming the file
protocol::Image readPlanes(const std::filesystem::path &file);

} // namespace grader
