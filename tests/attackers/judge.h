// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "../grading/grader/submission/hostile_archives.h"
#include "attack.h"
#include "host.h"
#include "marks.h"

namespace attack {

/// What was seen of one attacker.
struct Seen {
    bool contained = false; ///< it ended as it must, got nothing and left nothing
    std::string what = {};  ///< in a few words
    double gained = 0;      ///< points over what its honest part is worth
    Traces traces = {};
};

/// Lets attackers loose in boxes of one level, and looks for what they got and left.
class Judge {
public:
    /// \param quick  without asking attackers on processes and files for points
    Judge(grader::SandboxLevel level, bool quick);

    grader::SandboxLevel level() const { return m_sandbox.level(); }

    Seen run(const Attack &attack);
    /// Reads it with the sentinel tree around, and grades what is left of it.
    Seen run(const grader::test::HostileArchive &archive);

    /// The checks that catch cheats give all points to the same program when it does not cheat.
    bool honestPasses() const;

private:
    template <typename Act>
    Seen watched(const Act &act) const;

    Seen judge(const Attack &attack) const;
    Seen judgeProcess(const Attack &attack) const;
    Seen judgeProbe(const Attack &attack) const;
    Seen judgeCheat(const Attack &attack) const;
    Seen judgeSource(const Attack &attack) const;
    Seen judgeArchive(const grader::test::HostileArchive &archive) const;

    bool endsAs(End wanted, const grader::BoxOutcome &outcome) const;
    /// All checks of the item, asked of the program as a hand-in's probe is.
    std::vector<grader::CheckResult> ask(const Attack &attack) const;
    std::filesystem::path programOf(const Attack &attack) const;

    grader::Sandbox m_sandbox;
    Host m_host;
    Marks m_marks;
    bool m_quick;
    std::string
        m_run; ///< in every source, or what an earlier run has built would come from the cache
};

} // namespace attack
