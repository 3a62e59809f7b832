// SPDX-License-Identifier: MIT
#include <grader/submission/clutter.h>
#include <grader/submission/names.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace grader {

namespace {

struct FolderRow {
    const char *name; ///< lower case; a `*` at the end stands for anything
    const char *reason;
};

constexpr std::array kLeftOutFolders{
    FolderRow{"__macosx", "added by macOS when it packs"},
    FolderRow{".git", "version control"},
    FolderRow{".svn", "version control"},
    FolderRow{".hg", "version control"},
    FolderRow{".vs", "editor's settings"},
    FolderRow{".vscode", "editor's settings"},
    FolderRow{".idea", "editor's settings"},
    FolderRow{".cache", "editor's cache"},
    FolderRow{"build", "build folder"},
    FolderRow{"build-*", "build folder"},
    FolderRow{"build_*", "build folder"},
    FolderRow{"cmake-build*", "build folder"},
    FolderRow{"cmakefiles", "build folder"},
    FolderRow{"x64", "build folder"},
    FolderRow{"debug", "build folder"},
    FolderRow{"release", "build folder"},
    FolderRow{"relwithdebinfo", "build folder"},
    FolderRow{"ext", "the base's third-party libraries"},
};

struct SuffixRow {
    const char *extension;
    const char *reason;
};

constexpr std::array kClutterExtensions{
    SuffixRow{".o", "object file: only sources are built"},
    SuffixRow{".obj", "a mesh or an object file: neither is used"},
    SuffixRow{".a", "library: only sources are built"},
    SuffixRow{".lib", "library: only sources are built"},
    SuffixRow{".so", "library: only sources are built"},
    SuffixRow{".dll", "library: only sources are built"},
    SuffixRow{".dylib", "library: only sources are built"},
    SuffixRow{".exe", "program: only sources are built"},
    SuffixRow{".pdb", "debugger's data"},
    SuffixRow{".sln", "project file: the grader builds in its own way"},
    SuffixRow{".vcxproj", "project file: the grader builds in its own way"},
    SuffixRow{".cmake", "project file: the grader builds in its own way"},
    SuffixRow{".mtl", "material file: not used"},
    SuffixRow{".pdf", "document: not used"},
    SuffixRow{".docx", "document: not used"},
    SuffixRow{".doc", "document: not used"},
    SuffixRow{".odt", "document: not used"},
    SuffixRow{".xml", "scene: graded scenes are the grader's own"},
    SuffixRow{".bak", "backup"},
    SuffixRow{".orig", "backup"},
    SuffixRow{".swp", "editor's swap file"},
};

constexpr std::array kCopyWords{"copy",   "copia",    "copie",      "old",      "viejo",
                                "vieja",  "antiguo",  "antigua",    "original", "orig",
                                "backup", "bak",      "bkp",        "prev",     "previous",
                                "previo", "anterior", "deprecated", "nousar",   "unused"};

constexpr std::string_view kSeparators = "_- .(";

bool matches(std::string_view name, std::string_view pattern) {
    if (!pattern.empty() && pattern.back() == '*') {
        pattern.remove_suffix(1);
        return name.substr(0, pattern.size()) == pattern;
    }
    return name == pattern;
}

/// The words of a lower-case stem: "area - copia (2)" gives area, copia, 2.
std::vector<std::string> words(const std::string &stem) {
    std::vector<std::string> result(1);
    for (const char c : stem) {
        if (c == ')' || kSeparators.find(c) != std::string_view::npos) {
            if (!result.back().empty()) {
                result.emplace_back();
            }
        } else {
            result.back() += c;
        }
    }
    if (result.back().empty()) {
        result.pop_back();
    }
    return result;
}

bool isCopyWord(const std::string &word) {
    // copia2, copy3
    const std::string bare = word.substr(0, word.find_last_not_of("0123456789") + 1);
    return std::find(kCopyWords.begin(), kCopyWords.end(), bare) != kCopyWords.end();
}

/// 2, v1, ver2
bool isVersion(const std::string &word) {
    const std::size_t digits = word.find_first_of("0123456789");
    if (digits == std::string::npos ||
        word.find_first_not_of("0123456789", digits) != std::string::npos) {
        return false;
    }
    const std::string before = word.substr(0, digits);
    return before.empty() || before == "v" || before == "ver" || before == "version";
}

} // namespace

std::optional<LeftOutFolder> findLeftOutFolder(std::string_view path) {
    for (std::size_t begin = 0, end = path.find('/'); end != std::string_view::npos;
         begin = end + 1, end = path.find('/', begin)) {
        const std::string folder = lowerAscii(path.substr(begin, end - begin));
        const auto *row =
            std::find_if(kLeftOutFolders.begin(), kLeftOutFolders.end(),
                         [&](const FolderRow &each) { return matches(folder, each.name); });
        if (row != kLeftOutFolders.end()) {
            return LeftOutFolder{std::string(path.substr(0, end + 1)), row->reason};
        }
    }
    return std::nullopt;
}

bool LeftOutFolders::take(std::string_view path, std::size_t files) {
    const auto folder = findLeftOutFolder(path);
    if (!folder) {
        return false;
    }
    Seen &seen = m_seen[folder->path];
    seen.reason = folder->reason;
    seen.files += files;
    return true;
}

void LeftOutFolders::appendTo(std::vector<RawFile> &files) const {
    for (const auto &[path, seen] : m_seen) {
        const std::string count = seen.files > 0 ? fmt::format(" ({} files)", seen.files) : "";
        files.push_back({path, "", fmt::format("{}: not read{}", seen.reason, count)});
    }
}

std::string clutterReason(std::string_view path) {
    const PathParts parts = splitPath(path);
    const std::string name = lowerAscii(parts.name);
    if (name == ".ds_store" || name.substr(0, 2) == "._") {
        return "added by macOS when it packs";
    }
    if (name == "thumbs.db" || name == "desktop.ini") {
        return "added by Windows";
    }
    if (name == "cmakelists.txt" || name == "makefile") {
        return "never run: the grader builds in its own way";
    }
    if (!name.empty() && name.back() == '~') {
        return "backup";
    }
    for (const SuffixRow &row : kClutterExtensions) {
        if (parts.extension == row.extension) {
            return row.reason;
        }
    }
    return "";
}

bool isCopyFolder(std::string_view folder) {
    const std::vector<std::string> parts = words(lowerAscii(folder));
    return std::any_of(parts.begin(), parts.end(), isCopyWord);
}

std::optional<CopyName> findCopyName(std::string_view stem,
                                     const std::vector<std::string> &knownStems) {
    const std::string lower = lowerAscii(stem);
    const auto isKnown = [&](const std::string &text) {
        return std::find(knownStems.begin(), knownStems.end(), text) != knownStems.end();
    };
    const std::vector<std::string> parts = words(lower);
    const bool copyWord = parts.size() > 1 && std::any_of(parts.begin(), parts.end(), isCopyWord);
    // The longest known stem that starts the name and ends where a word ends.
    std::string original;
    for (const std::string &known : knownStems) {
        const bool starts = lower.size() > known.size() && lower.substr(0, known.size()) == known &&
                            (kSeparators.find(lower[known.size()]) != std::string_view::npos ||
                             isVersion(lower.substr(known.size())));
        if (starts && known.size() > original.size()) {
            original = known;
        }
    }
    if (!original.empty()) {
        const std::vector<std::string> rest = words(lower.substr(original.size()));
        const bool version = !rest.empty() && std::all_of(rest.begin(), rest.end(), isVersion);
        return CopyName{original, copyWord || version};
    }
    if (!copyWord) {
        return std::nullopt;
    }
    // "copia de area", "old_area": the original is the word that is known, if any.
    const auto known = std::find_if(parts.begin(), parts.end(), isKnown);
    return CopyName{known == parts.end() ? "" : *known, true};
}

} // namespace grader
