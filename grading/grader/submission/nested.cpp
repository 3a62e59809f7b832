// SPDX-License-Identifier: MIT
#include <grader/submission/archive_reader.h>
#include <grader/submission/base_names.h>
#include <grader/submission/names.h>
#include <grader/submission/nested.h>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace grader {

namespace {

bool holdsSources(const RawFiles &read) {
    return std::any_of(read.files.begin(), read.files.end(), [](const RawFile &file) {
        const auto base = findBaseName(splitPath(file.path).name);
        return file.refused.empty() && base && !base->isHeader && base->isReplaceable;
    });
}

struct Opened {
    std::size_t archive = 0; ///< index into the outer files
    RawFiles contents;
};

void open(RawFiles &read, ReadBudget &budget, int depth);

/// The contents of one archive; where it cannot be read, its entry says so.
RawFiles openOne(RawFile &archive, std::vector<Note> &notes, ReadBudget &budget, int depth) {
    RawFiles contents;
    try {
        contents = readArchiveBytes(archive.bytes, archive.path, budget);
        open(contents, budget, depth + 1);
    } catch (const LimitError &) {
        throw; // a bomb is a bomb wherever it lies
    } catch (const GraderError &error) {
        archive.refused = "an archive that cannot be read";
        notes.push_back({Note::Level::Human, archive.path, error.what()});
    }
    for (RawFile &file : contents.files) {
        file.path = archive.path + "/" + file.path;
    }
    for (Note &note : contents.notes) {
        note.file = note.file == archive.path ? note.file : archive.path + "/" + note.file;
    }
    archive.bytes.clear();
    return contents;
}

void merge(RawFiles &read, Opened &opened) {
    RawFile &archive = read.files[opened.archive];
    if (archive.refused.empty()) {
        archive.refused = "an archive: its files are listed on their own";
        read.notes.push_back({Note::Level::Info, archive.path, "An archive in it was opened."});
    }
    std::move(opened.contents.files.begin(), opened.contents.files.end(),
              std::back_inserter(read.files));
    std::move(opened.contents.notes.begin(), opened.contents.notes.end(),
              std::back_inserter(read.notes));
}

void leaveOut(RawFiles &read, const Opened &opened) {
    RawFile &archive = read.files[opened.archive];
    archive.refused = "an archive with sources beside other sources: not used";
    read.notes.push_back(
        {Note::Level::Human, archive.path,
         fmt::format("'{}' holds sources of the assignment, and so does another part of the "
                     "hand-in; it was not used. If it is what counts, grade it on its own.",
                     archive.path)});
}

void open(RawFiles &read, ReadBudget &budget, int depth) {
    std::vector<Opened> opened;
    const std::size_t outerCount = read.files.size();
    for (std::size_t i = 0; i < outerCount; ++i) {
        RawFile &file = read.files[i];
        if (!file.refused.empty() || !isArchiveName(file.path)) {
            continue;
        }
        if (depth >= budget.limits().archiveDepth) {
            file.refused = "an archive too deep within archives: not opened";
            file.bytes.clear();
            read.notes.push_back({Note::Level::Human, file.path,
                                  fmt::format("'{}' is more than {} archives deep: not opened.",
                                              file.path, budget.limits().archiveDepth)});
            continue;
        }
        opened.push_back({i, openOne(file, read.notes, budget, depth)});
    }
    const bool outer = holdsSources(read);
    const auto inner = std::count_if(opened.begin(), opened.end(), [](const Opened &each) {
        return holdsSources(each.contents);
    });
    for (Opened &each : opened) {
        if (holdsSources(each.contents) && (outer || inner > 1)) {
            leaveOut(read, each);
        } else {
            merge(read, each);
        }
    }
}

} // namespace

void openNestedArchives(RawFiles &read, ReadBudget &budget) {
    open(read, budget, 0);
}

} // namespace grader
