// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace grader {

/// Where everything that was built is kept, named by the digest of what it was built from. Only the
/// grader writes here; boxes see single files of it, read-only.
class Cache {
public:
    /// \param root  made if it is not there; every folder above it must be searchable by others
    /// \throws GraderError  if it cannot be made or written
    explicit Cache(std::filesystem::path root = defaultRoot());

    /// /var/cache/norigrade for root, else $XDG_CACHE_HOME/norigrade or ~/.cache/norigrade.
    static std::filesystem::path defaultRoot();

    /// Place of an entry: `<root>/<kind>/ab/cdef…<suffix>`.
    std::filesystem::path entry(const std::string &kind, const std::string &digest,
                                const std::string &suffix = "") const;

    /// A copy of one of our own programs, where boxes can reach it.
    /// \throws GraderError  if it cannot be read or written
    std::filesystem::path install(const std::filesystem::path &program) const;

    /// A new empty folder that a boxed process may write to. The caller removes it.
    std::filesystem::path makeScratch() const;

private:
    std::filesystem::path m_root;
};

} // namespace grader
