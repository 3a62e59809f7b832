// SPDX-License-Identifier: MIT
#pragma once

#include <grader/results/results.h>

#include <filesystem>
#include <string>
#include <vector>

namespace grader {

/// What a file of a hand-in is to us.
enum class FileRole {
    Source, ///< replaces the base's file of this name (`warp.cpp`)
    Extra,  ///< a source with a name of its own: linked only where something needs it
    Header, ///< replaces `<nori/name>` or is new
    Readme,
    Figure,
    Ignored, ///< not used; `reason` says why
};

struct SubmittedFile {
    std::string path; ///< as in the hand-in, UTF-8 (NFC), `/` separates
    std::string name; ///< last component, in the base's spelling for Source and Header
    FileRole role = FileRole::Ignored;
    std::string reason; ///< why it has this role, for the list of files
    std::string bytes;  ///< sources and headers: LF line ends, no BOM; figures: as sent
};

/// One hand-in: a zip or a folder, read into memory and sorted. Nothing of it has been run.
struct Submission {
    std::string name;                 ///< of the zip or folder
    std::vector<std::string> members; ///< NIPs, from `p2_NIP1_NIP2`
    std::string digest;               ///< SHA-256 over the sorted (path, bytes), hexadecimal
    std::vector<SubmittedFile> files;
    std::vector<Note> notes; ///< everything odd, ambiguous or left out

    /// The file of this role and `name`, or null.
    const SubmittedFile *find(FileRole role, const std::string &wanted) const;
};

/// Reads a hand-in.
/// \throws GraderError  if `path` is not there, is no archive, or breaks a limit (what, where, and
///                      what to do)
Submission readSubmission(const std::filesystem::path &path);

} // namespace grader
