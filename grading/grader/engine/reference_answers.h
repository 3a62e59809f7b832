// SPDX-License-Identifier: MIT
#pragma once

#include <grader/prober/prober.h>

#include <cstddef>
#include <map>
#include <string>

namespace grader {

/// What our own program answered while one check is run on one hand-in. Where that fails, the same
/// is asked for every variant that follows the mistake through, and our answers are the same: of an
/// image, three quarters of all samples. For one thread.
class ReferenceAnswers {
public:
    /// \return  lives as long as this object; nullptr if this was not asked before, or not kept
    const ProbeAnswer *find(const protocol::RequestGroup &group) const;

    /// Keeps a complete answer whose floats fit into what is left of 64 MiB: five of an image's
    /// seven looks. The others are asked for again.
    void keep(const protocol::RequestGroup &group, const ProbeAnswer &answer);

private:
    std::map<std::string, ProbeAnswer> m_answers; ///< by the digest of the question
    std::size_t m_bytes = 0;
};

} // namespace grader
