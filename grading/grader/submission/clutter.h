// SPDX-License-Identifier: MIT
#pragma once

#include <grader/submission/raw_files.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What comes along with a hand-in and is none of it.
namespace grader {

/// A folder whose files are not even read, because it can hold hundreds of megabytes.
struct LeftOutFolder {
    std::string path; ///< with a `/` at its end
    std::string reason;
};

/// The outermost folder of `path` that is left out, if there is one.
std::optional<LeftOutFolder> findLeftOutFolder(std::string_view path);

/// Counts the files of left-out folders, so that each folder is told of once.
class LeftOutFolders {
public:
    /// True if `path` lies in a folder that is left out; `files` are counted for it.
    bool take(std::string_view path, std::size_t files = 1);

    /// One entry per folder, with its reason and its number of files.
    void appendTo(std::vector<RawFile> &files) const;

private:
    struct Seen {
        std::string reason;
        std::size_t files = 0;
    };

    std::map<std::string, Seen> m_seen;
};

/// Why a single file is none of the hand-in's sources, headers, figures or README, if its name
/// tells; empty if it does not.
std::string clutterReason(std::string_view path);

/// True for `old`, `backup`, `area - copia` ...
bool isCopyFolder(std::string_view folder);

/// What a source's name says about being a copy of another one.
struct CopyName {
    std::string original; ///< lower-case stem of the file it copies: `area` for `area_old`
    bool certain = false; ///< the suffix says so (`_old`, ` - copia`), not just any `_NAME`
};

/// \param stem        Of the file that is looked at.
/// \param knownStems  Lower-case stems that a copy may be of.
std::optional<CopyName> findCopyName(std::string_view stem,
                                     const std::vector<std::string> &knownStems);

} // namespace grader
