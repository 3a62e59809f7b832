// SPDX-License-Identifier: MIT
#include <grader/error.h>
#include <grader/sandbox/cgroup.h>
#include <grader/sandbox/launch.h>
#include <grader/sandbox/orphans.h>
#include <grader/sandbox/supervisor.h>

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
    if (reason.find("nknown option") != std::string::npos)
        advice = "; bubblewrap 0.8 or newer is needed";
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
    if (::access(kBubblewrap, X_OK) != 0) {
        m_findings.emplace_back("bubblewrap: no; install the package bubblewrap");
        settle(SandboxLevel::S0);
        return;
    }
    m_findings.emplace_back("bubblewrap: yes");
    m_findings.emplace_back(::geteuid() == 0
                                ? "user: root; each box runs as a user of its own"
                                : "user: ordinary; submissions run as a user namespace's nobody");
    adoptOrphans();
    killOrphans();
    const std::string failure = tryOut(SandboxLevel::S2);
    if (!failure.empty()) {
        m_findings.push_back(namespaceAdvice(failure));
        settle(SandboxLevel::S0);
        return;
    }
    m_findings.emplace_back("namespaces, seccomp, limits: yes");
    m_cgroups = findCgroupPlaces();
    if (!m_cgroups.complete()) {
        m_findings.emplace_back("control groups: no; memory is limited per process only (root, or "
                                "a delegated group: systemd-run --user --scope, gives S3)");
        settle(SandboxLevel::S2);
        return;
    }
    const std::string grouped = tryOut(SandboxLevel::S3);
    m_findings.push_back(fmt::format("control groups: {} (version {}, {}{})",
                                     grouped.empty() ? "yes" : "no", m_cgroups.version2 ? 2 : 1,
                                     m_cgroups.memory.string(),
                                     grouped.empty() ? "" : ": " + grouped));
    settle(grouped.empty() ? SandboxLevel::S3 : SandboxLevel::S2);
}

std::string Sandbox::tryOut(SandboxLevel level) {
    m_level = level;
    BoxSpec trial;
    trial.argv = {"/true"};
    trial.binds = {{"/usr/bin/true", "/true", false}};
    try {
        const BoxOutcome outcome = run(trial);
        const auto *exited = std::get_if<BoxExited>(&outcome.end);
        return exited != nullptr && exited->code == 0 ? "" : describe(outcome.end);
    } catch (const GraderError &error) {
        return error.what();
    }
}

} // namespace grader
