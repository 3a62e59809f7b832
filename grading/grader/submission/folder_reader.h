// SPDX-License-Identifier: MIT
#pragma once

#include <grader/submission/raw_files.h>

#include <filesystem>

namespace grader {

/// Reads the plain files of a folder into memory, in the order of their paths. Links are refused,
/// so nothing outside the folder is read.
/// \throws LimitError   if a limit is passed
/// \throws GraderError  if the folder itself cannot be listed
RawFiles readFolder(const std::filesystem::path &root, ReadBudget &budget);

} // namespace grader
