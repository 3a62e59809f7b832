// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace grader {

/// \throws GraderError  if it cannot be read
std::string readTextFile(const std::filesystem::path &file);

/// Writes below a temporary name and renames, so that no reader sees half a file; makes the folders
/// above it. World-readable, because boxes read it as another user.
/// \throws GraderError  if it cannot be written
void writeTextFile(const std::filesystem::path &file, std::string_view bytes);

} // namespace grader
