// SPDX-License-Identifier: MIT
#pragma once

#include <grader/sandbox/descriptor.h>

namespace grader {

/// A file with the system call filter of a box, as bubblewrap's --seccomp reads it.
/// \param mayFork  compilers start processes; probes only threads
/// \throws GraderError  if libseccomp or the kernel refuses
Descriptor seccompFilter(bool mayFork);

} // namespace grader
