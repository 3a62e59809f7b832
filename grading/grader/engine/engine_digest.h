// SPDX-License-Identifier: MIT
#pragma once

#include <grader/sandbox/box.h>

#include <string>

namespace grader {

/// SHA-256 of what a measurement depends on beside the hand-in, the checks and the seed: this
/// program, our own probe, the code that hand-ins are laid over and linked with, the scenes, the
/// compiler, the level of the sandbox. Not the system's shared libraries.
/// \throws GraderError  if one of these cannot be read
std::string engineDigest(SandboxLevel level);

} // namespace grader
