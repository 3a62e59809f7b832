// SPDX-License-Identifier: MIT
#pragma once

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

} // namespace grader::test
