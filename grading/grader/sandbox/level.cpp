// SPDX-License-Identifier: MIT
#include <grader/sandbox/cgroup.h>

#include <fmt/core.h>

#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "box.h"

namespace grader {

namespace {

std::string firstLine(const char *file) {
    std::ifstream stream(file);
    std::string line;
    std::getline(stream, line);
    return line;
}

std::string namespaceAdvice(const std::string &reason) {
    std::string advice;
    if (firstLine("/proc/sys/kernel/unprivileged_userns_clone") == "0")
        advice = "; as administrator: sysctl -w kernel.unprivileged_userns_clone=1";
    if (firstLine("/proc/sys/kernel/apparmor_restrict_unprivileged_userns") == "1")
        advice = "; as administrator: sysctl -w kernel.apparmor_restrict_unprivileged_userns=0";
    if (firstLine("/proc/sys/user/max_user_namespaces") == "0")
        advice = "; as administrator: sysctl -w user.max_user_namespaces=10000";
    return fmt::format("namespaces: no ({}){}", reason, advice);
}

} // namespace

Sandbox::Sandbox(SandboxLevel wanted) {
    const auto settle = [&](SandboxLevel level) {
        m_level = std::min(level, wanted);
        m_findings.push_back(
            fmt::format("level: {}{}", sandboxLevelName(m_level),
                        m_level >= SandboxLevel::S2 ? "" : "; submissions are not run"));
    };
    if (::access("/usr/bin/bwrap", X_OK) != 0) {
        m_findings.emplace_back("bubblewrap: no; install the package bubblewrap");
        settle(SandboxLevel::S0);
        return;
    }
    m_findings.emplace_back("bubblewrap: yes");
    m_findings.push_back(::geteuid() == 0
                             ? "user: root; submissions run as user 65534"
                             : "user: ordinary; submissions run as a user namespace's nobody");
    m_cgroups = findCgroupPlaces();
    const bool cgroups = m_cgroups.complete();

    // The whole box is tried, with everything that a submission's will have.
    m_level = SandboxLevel::S2;
    BoxSpec trial;
    trial.argv = {"/usr/bin/true"};
    const BoxOutcome outcome = run(trial);
    const auto *exited = std::get_if<BoxExited>(&outcome.end);
    if (exited == nullptr || exited->code != 0) {
        m_findings.push_back(namespaceAdvice(describe(outcome.end)));
        settle(SandboxLevel::S0);
        return;
    }
    m_findings.emplace_back("namespaces, seccomp, limits: yes");
    m_findings.push_back(cgroups
                             ? fmt::format("control groups: yes (version {}, {})",
                                           m_cgroups.version2 ? 2 : 1, m_cgroups.memory.string())
                             : "control groups: no; memory is limited per process only (root, or "
                               "a delegated group, gives S3)");
    settle(cgroups ? SandboxLevel::S3 : SandboxLevel::S2);
}

} // namespace grader
