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

/// Something that answers questions as a probe does.
class ProbeClient {
public:
    virtual ~ProbeClient() = default;

    virtual ProbeAnswer ask(const protocol::RequestGroup &group) = 0;
};

/// Starts a probe in the box with sealed shared memory for questions (descriptor 3, read-only) and
/// answers (4), waits for its end or its limits, sees to it that nothing of it is left, and only
/// then reads the answers. What the probe prints, and how it ends, decides nothing.
/// \throws GraderError  if memory or processes have run out
ProbeAnswer askProbe(const Sandbox &sandbox, const std::filesystem::path &executable,
                     const protocol::RequestGroup &group, const BoxLimits &limits = {});

} // namespace grader
