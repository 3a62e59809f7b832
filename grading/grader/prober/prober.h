// SPDX-License-Identifier: MIT
#pragma once

#include <grader/sandbox/box.h>
#include <protocol/request.h>

#include <filesystem>
#include <string>
#include <vector>

namespace grader {

/// What a probe answered, read after its process was killed.
struct ProbeAnswer {
    BoxOutcome outcome;
    std::vector<protocol::Response> responses; ///< one per request, in order

    /// True when every request is Done.
    bool complete() const;
};

/// Starts a probe in the box with sealed shared memory for questions and answers, waits for its
/// end or its limits, kills it, and only then reads the answers. The executable takes no arguments:
/// questions are on descriptor 3 (read-only memory), answers on 4, "done" is one byte on 5.
ProbeAnswer askProbe(const Sandbox &sandbox, const std::filesystem::path &executable,
                     const protocol::RequestGroup &group, const BoxLimits &limits = {});

} // namespace grader
