// SPDX-License-Identifier: MIT
#include <grader/submission/clutter.h>
#include <grader/submission/duplicates.h>
#include <grader/submission/names.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <vector>

namespace grader {

namespace {

/// Smaller is more likely the one that is meant.
struct Rank {
    bool copyFolder = false; ///< below `old/`, `backup/` ...
    int folder = 0;
    std::size_t depth = 0;
    std::string path;

    bool operator<(const Rank &other) const {
        return std::tie(copyFolder, folder, depth, path) <
               std::tie(other.copyFolder, other.folder, other.depth, other.path);
    }
};

Rank rankOf(const SubmittedFile &file) {
    const PathParts parts = splitPath(file.path);
    const std::string folder = parts.folders.empty() ? "" : lowerAscii(parts.folders.back());
    Rank rank;
    rank.copyFolder = std::any_of(parts.folders.begin(), parts.folders.end(),
                                  [](const std::string &each) { return isCopyFolder(each); });
    if (file.role == FileRole::Header) {
        rank.folder = folder == "nori" ? 0 : (folder == "src" ? 1 : 2);
    } else {
        rank.folder = folder == "src" ? 0 : 1;
    }
    rank.depth = parts.folders.size();
    rank.path = file.path;
    return rank;
}

void keepFirst(std::vector<SubmittedFile *> &same, std::vector<Note> &notes) {
    std::sort(same.begin(), same.end(), [](const SubmittedFile *a, const SubmittedFile *b) {
        return rankOf(*a) < rankOf(*b);
    });
    const SubmittedFile &used = *same.front();
    for (auto it = same.begin() + 1; it != same.end(); ++it) {
        SubmittedFile &file = **it;
        const bool equal = file.bytes == used.bytes;
        file.role = FileRole::Ignored;
        file.reason = fmt::format("{} '{}', which is used", equal ? "the same as" : "differs from",
                                  used.path);
        if (equal) {
            notes.push_back({Note::Level::Info, file.path,
                             fmt::format("'{}' and '{}' are the same.", file.path, used.path)});
        } else {
            notes.push_back({Note::Level::Human, file.path,
                             fmt::format("There are two different files for {}: '{}' was used, "
                                         "'{}' was not.",
                                         used.name, used.path, file.path)});
        }
    }
}

void notePathCollisions(Submission &submission) {
    std::map<std::string, const SubmittedFile *> seen;
    for (const SubmittedFile &file : submission.files) {
        const auto [first, isNew] = seen.emplace(foldName(file.path), &file);
        if (!isNew) {
            const bool code = file.role == FileRole::Source || file.role == FileRole::Header ||
                              file.role == FileRole::Extra;
            submission.notes.push_back(
                {code ? Note::Level::Human : Note::Level::Odd, file.path,
                 fmt::format("'{}' and '{}' are the same path on Windows and macOS.",
                             first->second->path, file.path)});
        }
    }
}

} // namespace

void keepOneOfEach(Submission &submission) {
    notePathCollisions(submission);
    std::map<std::pair<FileRole, std::string>, std::vector<SubmittedFile *>> byName;
    for (SubmittedFile &file : submission.files) {
        if (file.role == FileRole::Source || file.role == FileRole::Header ||
            file.role == FileRole::Extra) {
            byName[{file.role, foldName(file.name)}].push_back(&file);
        }
    }
    for (auto &[name, same] : byName) {
        keepFirst(same, submission.notes);
    }
}

} // namespace grader
