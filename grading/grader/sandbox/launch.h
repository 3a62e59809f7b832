// SPDX-License-Identifier: MIT
#pragma once

#include <grader/sandbox/box.h>
#include <grader/sandbox/descriptor.h>

#include <sys/types.h>

namespace grader {

class Cgroup;

constexpr char kBubblewrap[] = "/usr/bin/bwrap";

/// A started bubblewrap.
struct Launched {
    pid_t process = -1;
    Descriptor log;    ///< its stdout and stderr
    Descriptor status; ///< bubblewrap's --json-status-fd
};

/// Starts a box: own user (when we are root), limits, control group, then bubblewrap.
/// \param cgroup  may be null
/// \throws GraderError  if no process can be started
Launched launch(const BoxSpec &spec, Cgroup *cgroup);

/// bubblewrap's arguments for a box; the filter and the status are on these descriptors.
std::vector<std::string> bubblewrapArguments(const BoxSpec &spec, int statusFd, int filterFd);

} // namespace grader
