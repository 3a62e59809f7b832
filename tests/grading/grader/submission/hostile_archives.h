// SPDX-License-Identifier: MIT
#pragma once

#include <grader/submission/submission.h>

#include <filesystem>
#include <string>
#include <vector>

namespace grader::test {

/// An archive that was made to do harm or that went wrong on its way, and what must come of it.
struct HostileArchive {
    const char *name; ///< of the case, as an identifier
    std::string (*make)();
    const char *refused; ///< part of the error that refuses it as a whole; null: it is read
    const char *said;    ///< part of a note or of a file's reason, if it is read
    bool honest;         ///< whether its honest file, src/mesh.cpp, is taken as a source
};

// One table for each place that is attacked.
std::vector<HostileArchive> hostilePaths();   ///< names that lead elsewhere, or hide something
std::vector<HostileArchive> hostileEntries(); ///< links, devices, encryption, two of one name
std::vector<HostileArchive> hostileSizes();   ///< bombs, and more than is allowed
std::vector<HostileArchive> brokenArchives(); ///< cut, changed, contradicting, of another kind

/// What came of reading one.
struct ReadArchive {
    Submission submission;
    std::string error; ///< that refused it as a whole; empty: it was read
    std::string fault; ///< in which it is not what must come of it, bounds of time and memory
                       ///< included; empty: in nothing
};

/// Reads `file`, which holds the archive.
ReadArchive readHostileArchive(const HostileArchive &archive, const std::filesystem::path &file);

} // namespace grader::test
