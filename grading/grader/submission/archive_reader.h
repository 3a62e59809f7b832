// SPDX-License-Identifier: MIT
#pragma once

#include <grader/submission/raw_files.h>

#include <filesystem>
#include <string>
#include <string_view>

/// Reads archives into memory: zip, tar (plain, gzip, bzip2, xz, zstd), 7z and rar.
///
/// Nothing is written to disk and nothing is run; names are only text. Entries that are no plain
/// files (links, devices) and those with a path that leads out of the archive are refused one by
/// one. An archive that is damaged or partly encrypted gives what can be read, with a note for a
/// person.
namespace grader {

/// True for names of archives: `.zip`, `.7z`, `.tar.gz` ...
bool isArchiveName(std::string_view name);

/// \throws LimitError   if a limit is passed
/// \throws GraderError  if nothing at all can be read (no archive, encrypted, damaged)
RawFiles readArchiveFile(const std::filesystem::path &path, ReadBudget &budget);

/// The same for an archive in memory; `label` is its name in messages.
RawFiles readArchiveBytes(std::string_view bytes, const std::string &label, ReadBudget &budget);

} // namespace grader
