// SPDX-License-Identifier: MIT
#include <grader/digest.h>
#include <grader/submission/archive_reader.h>
#include <grader/submission/folder_reader.h>
#include <grader/submission/layout.h>
#include <grader/submission/members.h>
#include <grader/submission/names.h>
#include <grader/submission/nested.h>
#include <grader/submission/papers.h>
#include <grader/submission/reading.h>
#include <grader/submission/submission.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace grader {

namespace {

namespace fs = std::filesystem;

/// Sources that the handout asks for; which of them cost points is the rubric's to say.
constexpr std::array<const char *, 5> kAskedSources{"warp.cpp", "mesh.cpp", "area.cpp",
                                                    "environment.cpp", "direct_ems.cpp"};

/// Paths and contents with their lengths, so that nothing can be moved from one to the other.
std::string digestOf(const std::vector<RawFile> &files) {
    std::vector<const RawFile *> sorted;
    sorted.reserve(files.size());
    for (const RawFile &file : files) {
        sorted.push_back(&file);
    }
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const RawFile *a, const RawFile *b) { return a->path < b->path; });
    std::string list;
    for (const RawFile *file : sorted) {
        list += fmt::format("{} {} {}\n", file->path.size(), file->path, sha256Hex(file->bytes));
    }
    return sha256Hex(list);
}

std::string baseName(const fs::path &path, bool folder) {
    const fs::path clean = path.has_filename() ? path : path.parent_path();
    const std::string name = fs::weakly_canonical(clean).filename().string();
    std::string decoded = decodeNames({name}).front();
    while (!folder && isArchiveName(decoded)) {
        decoded = splitPath(decoded).stem; // tar.gz has two
    }
    return decoded;
}

/// What the folders and archives within a hand-in say of its members; the first that says anything.
NamedMembers membersWithin(const Submission &submission) {
    for (const SubmittedFile &file : submission.files) {
        for (const std::string &folder : splitPath(file.path).folders) {
            NamedMembers named =
                parseMembers(isArchiveName(folder) ? splitPath(folder).stem : folder);
            if (named.assignment == "p2") {
                return named;
            }
        }
    }
    return {};
}

/// Members from the name of the hand-in, else from an archive or folder within it.
void findMembers(Submission &submission) {
    NamedMembers named = parseMembers(submission.name);
    const NamedMembers within = membersWithin(submission);
    if (named.members.empty()) {
        named = within;
    } else if (!within.members.empty() &&
               !std::is_permutation(named.members.begin(), named.members.end(),
                                    within.members.begin(), within.members.end())) {
        submission.notes.push_back(
            {Note::Level::Human, "",
             fmt::format("The hand-in is named for {}, a folder in it for {}: whose is it?",
                         fmt::join(named.members, ", "), fmt::join(within.members, ", "))});
    }
    submission.members = named.members;
    if (named.members.empty()) {
        submission.notes.push_back(
            {Note::Level::Human, "",
             fmt::format("'{}' is not named p2_NIP1_NIP2: whose it is must be told by hand.",
                         submission.name)});
    } else if (named.assignment != "p2") {
        submission.notes.push_back({Note::Level::Human, "",
                                    fmt::format("'{}' is named as assignment {}, not p2.",
                                                submission.name, named.assignment)});
    } else if (!parseMembers(submission.name).asAsked) {
        submission.notes.push_back({Note::Level::Odd, "",
                                    fmt::format("'{}' is not named p2_NIP1_NIP2; taken as {}.",
                                                submission.name, fmt::join(named.members, ", "))});
    }
}

void checkSources(Submission &submission) {
    std::vector<std::string> missing;
    for (const char *name : kAskedSources) {
        if (submission.find(FileRole::Source, name) == nullptr) {
            missing.emplace_back(name);
        }
    }
    const bool anyCode = std::any_of(
        submission.files.begin(), submission.files.end(), [](const SubmittedFile &file) {
            return file.role == FileRole::Source || file.role == FileRole::Extra ||
                   file.role == FileRole::Header;
        });
    if (!anyCode) {
        submission.notes.push_back(
            {Note::Level::Human, "",
             submission.files.empty()
                 ? "The hand-in is empty."
                 : "There is nothing of the assignment in it: no source and no header that is "
                   "used. Is it the right file?"});
    } else if (!missing.empty()) {
        submission.notes.push_back(
            {Note::Level::Odd, "",
             fmt::format("Sources that the handout asks for and that are not here: {}.",
                         fmt::join(missing, ", "))});
    }
}

} // namespace

const SubmittedFile *Submission::find(FileRole role, const std::string &wanted) const {
    const auto found = std::find_if(files.begin(), files.end(), [&](const SubmittedFile &file) {
        return file.role == role && file.name == wanted;
    });
    return found == files.end() ? nullptr : &*found;
}

Submission readSubmission(const fs::path &path, const ReadLimits &limits) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) {
        throw GraderError(fmt::format("{}: no such file or folder", path.string()));
    }
    const bool folder = fs::is_directory(status);
    if (!folder && !fs::is_regular_file(status)) {
        throw GraderError(
            fmt::format("{}: neither a file nor a folder; give a zip or a folder", path.string()));
    }
    ReadBudget budget(limits, path.string());
    RawFiles raw = folder ? readFolder(path, budget) : readArchiveFile(path, budget);

    Submission submission;
    submission.name = baseName(path, folder);
    submission.digest = digestOf(raw.files);
    openNestedArchives(raw, budget);
    submission.notes = std::move(raw.notes);
    sortFiles(raw.files, submission);
    findMembers(submission);
    checkSources(submission);
    checkPapers(submission);
    return submission;
}

Submission readSubmission(const fs::path &path) {
    return readSubmission(path, ReadLimits{});
}

} // namespace grader
