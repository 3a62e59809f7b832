// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace grader {

bool isUtf8(std::string_view bytes);

/// `bytes` in `charset` (an ICU name, `windows-1252`) as UTF-8; what cannot be mapped is U+FFFD.
std::string toUtf8(std::string_view bytes, const char *charset);

/// File names as archives and disks hold them, as UTF-8 in NFC.
///
/// A name that is valid UTF-8 is taken as that. The others are read in the one of CP850, CP437,
/// Windows-1252 and Latin-1 that gives the most plausible text for all of them together: zips made
/// on Windows do not say which they use.
std::vector<std::string> decodeNames(const std::vector<std::string> &raw);

/// The same text for names that differ only in case or Unicode form.
std::string foldName(std::string_view utf8);

/// ASCII lower case; the other bytes stay.
std::string lowerAscii(std::string_view text);

/// Why a path must not be used, empty if it may: absolute, a drive, `..`, too long.
std::string pathFault(std::string_view path);

/// Shortens a name that is shown, at a character's border.
std::string shortened(std::string_view utf8, std::size_t bytes = 200);

/// The parts of a path that say where and what a file is.
struct PathParts {
    std::vector<std::string> folders;
    std::string name;      ///< `Warp.CPP`
    std::string stem;      ///< `Warp`
    std::string extension; ///< `.cpp`, lower case
};

PathParts splitPath(std::string_view path);

} // namespace grader
