// SPDX-License-Identifier: MIT
#include <grader/submission/base_names.h>
#include <grader/submission/clutter.h>
#include <grader/submission/extras.h>
#include <grader/submission/names.h>
#include <grader/submission/source_scan.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace grader {

namespace {

class ExtraSorting {
public:
    explicit ExtraSorting(Submission &submission) : m_submission(submission) {}

    void run();

private:
    void collect();
    void ignoreCopies();
    void ignoreCopy(SubmittedFile &file, const CopyName &copy);
    void placeRegisteredTypes();
    void ignoreSecondDefinitions();
    const SubmittedFile *findSharing(const SubmittedFile &file, FileRole role) const;

    void note(Note::Level level, const std::string &path, const std::string &text) {
        m_submission.notes.push_back({level, path, text});
    }

    Submission &m_submission;
    std::vector<SubmittedFile *> m_extras;
    std::map<const SubmittedFile *, SourceScan> m_scans;
    std::vector<std::string> m_stems; ///< that a copy may be of, lower case
};

void ExtraSorting::collect() {
    m_stems = baseStems();
    for (SubmittedFile &file : m_submission.files) {
        const bool extra = file.role == FileRole::Extra;
        if (extra || file.role == FileRole::Source) {
            m_scans[&file] = scanSource(file.bytes);
        }
        if (extra) {
            m_extras.push_back(&file);
            m_stems.push_back(lowerAscii(splitPath(file.name).stem));
        }
    }
}

/// The first other file of `role` that defines something that `file` defines too.
const SubmittedFile *ExtraSorting::findSharing(const SubmittedFile &file, FileRole role) const {
    for (const SubmittedFile &other : m_submission.files) {
        if (&other != &file && other.role == role &&
            m_scans.at(&file).sharesWith(m_scans.at(&other))) {
            return &other;
        }
    }
    return nullptr;
}

void ExtraSorting::ignoreCopy(SubmittedFile &file, const CopyName &copy) {
    const std::string original = copy.original.empty() ? "" : copy.original + ".cpp";
    file.role = FileRole::Ignored;
    file.reason = original.empty() ? "by its name a copy of another file"
                                   : fmt::format("by its name a copy of {}", original);
    const auto base = findBaseName(original);
    const bool onlyOne =
        base && base->isReplaceable && m_submission.find(FileRole::Source, base->name) == nullptr;
    if (onlyOne) {
        note(Note::Level::Human, file.path,
             fmt::format("There is no {}, but '{}' looks like a copy of it; it was not used. "
                         "Rename it if it is what counts.",
                         base->name, file.path));
    } else {
        note(Note::Level::Odd, file.path,
             fmt::format("'{}' was not used: {}.", file.path, file.reason));
    }
}

void ExtraSorting::ignoreCopies() {
    for (SubmittedFile *file : m_extras) {
        const auto copy = findCopyName(splitPath(file->name).stem, m_stems);
        if (!copy) {
            continue;
        }
        // `mesh_tools.cpp` is named like a classmate's `mesh_NAME.cpp`: what it defines decides.
        const auto base = findBaseName(copy->original + ".cpp");
        const bool comparable = base && m_submission.find(FileRole::Source, base->name) != nullptr;
        const std::set<std::string> &types = m_scans[file].registeredTypes;
        const bool shares =
            types.count(copy->original) > 0 || findSharing(*file, FileRole::Source) != nullptr;
        const bool hasOwnType = !types.empty() && !shares;
        if (shares || (!hasOwnType && (copy->certain || (base && !comparable)))) {
            ignoreCopy(*file, *copy);
        } else {
            file->reason = "a further source: named like a copy, but it defines nothing twice";
        }
    }
}

void ExtraSorting::placeRegisteredTypes() {
    for (const std::string &name : replaceableSources()) {
        if (m_submission.find(FileRole::Source, name) != nullptr) {
            continue;
        }
        std::vector<SubmittedFile *> candidates;
        for (SubmittedFile *file : m_extras) {
            if (file->role == FileRole::Extra &&
                m_scans[file].registeredTypes.count(splitPath(name).stem) > 0) {
                candidates.push_back(file);
            }
        }
        if (candidates.empty()) {
            continue;
        }
        SubmittedFile &file = *candidates.front();
        file.role = FileRole::Source;
        file.name = name;
        file.reason =
            fmt::format("registers '{}', so it stands for {}", splitPath(name).stem, name);
        note(candidates.size() == 1 ? Note::Level::Odd : Note::Level::Human, file.path,
             fmt::format("There is no {}; '{}' {}.", name, file.path, file.reason));
    }
}

/// What is left must not define what another file defines: it would not link.
void ExtraSorting::ignoreSecondDefinitions() {
    for (SubmittedFile *file : m_extras) {
        if (file->role != FileRole::Extra) {
            continue;
        }
        const SubmittedFile *source = findSharing(*file, FileRole::Source);
        const SubmittedFile *extra =
            source == nullptr ? findSharing(*file, FileRole::Extra) : source;
        if (extra == nullptr) {
            continue;
        }
        file->role = FileRole::Ignored;
        file->reason = fmt::format("defines what '{}' defines, which is used", extra->path);
        note(source != nullptr ? Note::Level::Odd : Note::Level::Human, file->path,
             fmt::format("'{}' was not used: it {}.", file->path, file->reason));
    }
}

void ExtraSorting::run() {
    collect();
    ignoreCopies();
    placeRegisteredTypes();
    ignoreSecondDefinitions();
}

} // namespace

void sortExtras(Submission &submission) {
    ExtraSorting(submission).run();
}

} // namespace grader
