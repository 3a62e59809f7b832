// SPDX-License-Identifier: MIT
#pragma once

#include <grader/sandbox/box.h>
#include <grader/sandbox/descriptor.h>
#include <grader/sandbox/launch.h>

#include <chrono>
#include <optional>
#include <string>

namespace grader {

class Cgroup;

/// Makes this process the one that adopts orphans, so that the first process of a box can be waited
/// for when bubblewrap has ended before it. Once per process.
void adoptOrphans();

/// What it means that the wall clock ran out on a box, all in seconds: starved, if it computed
/// little, and a thread of it could have run and had no processor for most of the time. One that
/// keeps itself waiting, with many processes, has computed much.
BoxEnd endOfTime(double wall, double cpu, double waited);

/// Follows one box to its end, and sees to it that nothing of it is left.
class Supervisor {
public:
    /// \param cgroup  may be null; outlives this
    Supervisor(const BoxSpec &spec, Launched launched, Cgroup *cgroup)
        : m_spec(spec), m_launched(std::move(launched)), m_cgroup(cgroup) {}

    ~Supervisor() { endAll(); }

    Supervisor(const Supervisor &) = delete;
    Supervisor &operator=(const Supervisor &) = delete;
    Supervisor(Supervisor &&) = delete;
    Supervisor &operator=(Supervisor &&) = delete;

    BoxOutcome run();

private:
    using Clock = std::chrono::steady_clock;

    void follow(Clock::time_point deadline);
    void readSome(Clock::duration timeout);
    void endAll();
    int exitCode() const;
    BoxEnd end(bool outOfMemory) const;

    const BoxSpec &m_spec;
    Launched m_launched;
    Cgroup *m_cgroup;
    bool m_named = false; ///< bubblewrap has said which process is the first of the namespace
    Descriptor m_first;   ///< pidfd of that process, unless it has gone already
    std::string m_log;
    std::string m_status;
    bool m_logEnd = false;
    bool m_statusEnd = false;
    std::optional<BoxEnd> m_early; ///< what we have ended it for
    double m_cpuSeconds = 0;
    double m_waited = 0; ///< seconds that the thread of the box which waited most had no processor
};

} // namespace grader
