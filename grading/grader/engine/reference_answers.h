// SPDX-License-Identifier: MIT
#pragma once

#include <grader/prober/prober.h>

#include <cstddef>
#include <map>
#include <string>

namespace grader {

/// What our own program answered while a check was run on the hand-in. Where it failed, the same
/// questions are asked for every variant that follows the mistake through, and our answers, three
/// quarters of the sampling, are the same.
class ReferenceAnswers {
public:
    /// \return  nullptr if this was not asked before, or not kept
    const ProbeAnswer *find(const protocol::RequestGroup &group) const;

    /// Keeps complete answers until they fill 64 MiB; those of longer looks are asked for again.
    void keep(const protocol::RequestGroup &group, const ProbeAnswer &answer);

private:
    std::map<std::string, ProbeAnswer> m_answers; ///< by the digest of the question
    std::size_t m_bytes = 0;
};

} // namespace grader
