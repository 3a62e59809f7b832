// SPDX-License-Identifier: MIT
#include "box.h"

#include <grader/error.h>
#include <grader/sandbox/cgroup.h>
#include <grader/sandbox/guard.h>
#include <grader/sandbox/launch.h>
#include <grader/sandbox/supervisor.h>

#include <fmt/core.h>

#include <cstring>
#include <optional>

namespace grader {

const char *sandboxLevelName(SandboxLevel level) {
    constexpr const char *kNames[] = {"S0", "S1", "S2", "S3"};
    return kNames[static_cast<int>(level)];
}

std::string describe(const BoxEnd &end) {
    struct Describe {
        std::string operator()(const BoxExited &exited) const {
            return fmt::format("it exited with code {}", exited.code);
        }

        std::string operator()(const BoxSignalled &signalled) const {
            return fmt::format("it was ended by signal {} ({})", signalled.signal,
                               ::strsignal(signalled.signal));
        }

        std::string operator()(const BoxTimedOut &timedOut) const {
            return timedOut.cpu ? "it used up its CPU time" : "it used up its time";
        }

        std::string operator()(const BoxStarved &starved) const {
            return fmt::format("the machine was too busy: it waited {:.0f} s for a processor; run "
                               "it again with fewer jobs, or less beside it",
                               starved.waited);
        }

        std::string operator()(const BoxOutOfMemory &) const { return "it used up its memory"; }

        std::string operator()(const BoxLogTooLarge &) const { return "it printed too much"; }

        std::string operator()(const BoxNotStarted &notStarted) const {
            return "it could not be started: " + notStarted.reason;
        }
    };

    return std::visit(Describe(), end);
}

std::string ownFailure(const BoxEnd &end) {
    const bool isOurs =
        std::holds_alternative<BoxNotStarted>(end) || std::holds_alternative<BoxStarved>(end);
    return isOurs ? describe(end) : "";
}

BoxOutcome Sandbox::run(const BoxSpec &spec) const {
    if (m_level < SandboxLevel::S2)
        throw GraderError("this machine cannot lock submissions in, so none is run; `norigrade "
                          "doctor` says what is missing");
    keepGuard();
    std::optional<Cgroup> cgroup;
    if (m_level == SandboxLevel::S3)
        cgroup.emplace(m_cgroups, spec.limits);
    Cgroup *const group = cgroup ? &*cgroup : nullptr;
    return Supervisor(spec, launch(spec, group), group).run();
}

} // namespace grader
