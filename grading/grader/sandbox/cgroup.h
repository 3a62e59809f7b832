// SPDX-License-Identifier: MIT
#pragma once

#include <grader/sandbox/box.h>
#include <grader/sandbox/descriptor.h>

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace grader {

/// Tries to make a group below this process's own, per controller.
CgroupPlaces findCgroupPlaces();

/// Control groups of one box; removed with it, and whatever is in them is killed.
class Cgroup {
public:
    /// \throws GraderError  if it cannot be made
    Cgroup(const CgroupPlaces &places, const BoxLimits &limits);
    ~Cgroup();
    Cgroup(const Cgroup &) = delete;
    Cgroup &operator=(const Cgroup &) = delete;
    Cgroup(Cgroup &&) = delete;
    Cgroup &operator=(Cgroup &&) = delete;

    /// Files for writing: a process that writes "0" to each is in it.
    /// \throws GraderError  if they cannot be opened
    std::vector<Descriptor> entrances() const;

    /// True if the kernel has killed something in it for want of memory.
    bool ranOutOfMemory() const;

    /// Kills every process in it and waits until there is none.
    void killAll();

private:
    /// Completes an empty one, so that the destructor runs if the public constructor throws.
    explicit Cgroup(bool version2) : m_version2(version2) {}

    std::vector<std::filesystem::path> m_folders;
    bool m_version2;
};

} // namespace grader
