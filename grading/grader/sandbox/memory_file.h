// SPDX-License-Identifier: MIT
#pragma once

#include <grader/sandbox/descriptor.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace grader {

/// Anonymous file in memory, to hand to a box.
/// \throws GraderError  if memory or descriptors have run out
Descriptor makeMemoryFile(const char *name, std::string_view bytes);

/// Forbids for good, to every holder, what F_SEAL_... name; no seal can be added afterwards.
/// \throws GraderError
void sealMemoryFile(const Descriptor &file, int seals);

/// Copies the first `size` bytes.
/// \throws GraderError  if it has fewer
std::string readMemoryFile(const Descriptor &file, std::size_t size);

} // namespace grader
