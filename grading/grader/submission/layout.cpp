// SPDX-License-Identifier: MIT
#include <grader/submission/archive_reader.h>
#include <grader/submission/base_names.h>
#include <grader/submission/clutter.h>
#include <grader/submission/duplicates.h>
#include <grader/submission/extras.h>
#include <grader/submission/layout.h>
#include <grader/submission/members.h>
#include <grader/submission/names.h>
#include <grader/submission/papers.h>
#include <grader/submission/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace grader {

namespace {

constexpr std::size_t kMaxSourceBytes = 1U << 20U; ///< the base's longest has 20 KiB
constexpr std::size_t kMaxAllSourceBytes = 16U << 20U;

template <std::size_t N>
bool isOneOf(const std::string &text, const std::array<const char *, N> &table) {
    return std::find(table.begin(), table.end(), text) != table.end();
}

bool isSourceExtension(const std::string &extension) {
    static constexpr std::array<const char *, 4> kExtensions{".cpp", ".cc", ".cxx", ".c++"};
    return isOneOf(extension, kExtensions);
}

bool isHeaderExtension(const std::string &extension) {
    static constexpr std::array<const char *, 6> kExtensions{".h",   ".hpp", ".hh",
                                                             ".hxx", ".inl", ".ipp"};
    return isOneOf(extension, kExtensions);
}

/// A name that can be staged and given to a compiler: nothing that a tool could take for an option
/// or a response file, no control characters.
bool isSafeName(const std::string &name) {
    const bool plain = std::all_of(name.begin(), name.end(), [](char c) {
        return static_cast<unsigned char>(c) >= 0x80 ||
               std::isalnum(static_cast<unsigned char>(c)) != 0 ||
               std::string_view(" _.-+()").find(c) != std::string_view::npos;
    });
    return plain && name.front() != '-' && name.front() != '.' && name.front() != ' ';
}

class Sorting {
public:
    explicit Sorting(Submission &submission) : m_submission(submission) {}

    void add(const RawFile &raw);
    void finish();

private:
    void classify(SubmittedFile &file, const RawFile &raw);
    void classifyCode(SubmittedFile &file, const PathParts &parts, const std::string &bytes);
    void nameSource(SubmittedFile &file, const PathParts &parts);
    void ignoreCode(SubmittedFile &file, const std::string &why);
    void readBuildHints(const RawFile &raw);
    void ignoreOtherAssignments();
    void noteOwned();
    void keepOneReadme();
    void noteBuildHints();

    void note(Note::Level level, const std::string &path, const std::string &text) {
        m_submission.notes.push_back({level, path, text});
    }

    Submission &m_submission;
    std::size_t m_sourceBytes = 0;
    std::vector<std::string> m_owned;      ///< paths of files that stay the grader's own
    std::vector<std::string> m_buildHints; ///< sources that a CMakeLists.txt names
};

void Sorting::add(const RawFile &raw) {
    SubmittedFile file;
    file.path = raw.path;
    file.name = splitPath(raw.path).name;
    file.reason = raw.refused;
    if (raw.refused.empty()) {
        classify(file, raw);
    }
    m_submission.files.push_back(std::move(file));
}

void Sorting::classify(SubmittedFile &file, const RawFile &raw) {
    const PathParts parts = splitPath(raw.path);
    file.reason = clutterReason(raw.path);
    if (lowerAscii(parts.name) == "cmakelists.txt") {
        readBuildHints(raw);
    }
    if (!file.reason.empty()) {
        return;
    }
    if (isSourceExtension(parts.extension) || isHeaderExtension(parts.extension)) {
        classifyCode(file, parts, raw.bytes);
    } else if (isReadmeName(parts.name)) {
        file.role = FileRole::Readme;
        file.reason = "README";
        file.bytes = readmeText(raw.bytes);
    } else if (isFigureName(parts.name)) {
        file.role = FileRole::Figure;
        file.reason = "figure";
        file.bytes = raw.bytes;
    } else {
        file.reason = isArchiveName(parts.name) ? "an archive: not opened"
                                                : "no source, header, figure or README";
    }
}

void Sorting::ignoreCode(SubmittedFile &file, const std::string &why) {
    file.role = FileRole::Ignored;
    file.reason = why;
    note(Note::Level::Human, file.path,
         fmt::format("'{}' was not used: {}.", shortened(file.path), why));
}

void Sorting::classifyCode(SubmittedFile &file, const PathParts &parts, const std::string &bytes) {
    m_sourceBytes += bytes.size();
    if (bytes.size() > kMaxSourceBytes || m_sourceBytes > kMaxAllSourceBytes) {
        ignoreCode(file, "too large for source code");
        return;
    }
    NormalizedText text = normalizeText(bytes);
    if (text.hasNul) {
        ignoreCode(file, "it holds zero bytes, so it is no source code");
        return;
    }
    if (text.wasUtf16) {
        note(Note::Level::Odd, file.path,
             fmt::format("'{}' is in UTF-16; it was converted to UTF-8.", shortened(file.path)));
    }
    file.bytes = std::move(text.text);
    nameSource(file, parts);
    const bool blank = file.bytes.find_first_not_of(" \t\n") == std::string::npos;
    if (blank && file.role == FileRole::Extra) {
        file.role = FileRole::Ignored;
        file.reason = "empty";
    } else if (blank && file.role == FileRole::Source) {
        note(Note::Level::Odd, file.path, fmt::format("'{}' is empty.", shortened(file.path)));
    }
}

void Sorting::nameSource(SubmittedFile &file, const PathParts &parts) {
    const bool header = isHeaderExtension(parts.extension);
    const auto base = findBaseName(header ? parts.name : parts.stem + ".cpp");
    if (!base) {
        if (!isSafeName(parts.name)) {
            ignoreCode(file, "its name could be taken for something else by a compiler");
            return;
        }
        file.role = header ? FileRole::Header : FileRole::Extra;
        file.reason = header ? "a new header" : "a further source";
        return;
    }
    if (!base->isReplaceable) {
        file.reason = fmt::format("{} stays the grader's own", base->name);
        m_owned.push_back(shortened(file.path));
        return;
    }
    if (parts.name != base->name) {
        note(Note::Level::Odd, file.path,
             fmt::format("'{}' is taken for {}.", shortened(file.path), base->name));
    }
    file.name = base->name;
    file.role = header ? FileRole::Header : FileRole::Source;
    file.reason = header ? fmt::format("replaces <nori/{}>", base->name)
                         : fmt::format("replaces the base's {}", base->name);
}

void Sorting::readBuildHints(const RawFile &raw) {
    const std::string text = normalizeText(std::string_view(raw.bytes).substr(0, 1U << 16U)).text;
    for (std::size_t at = text.find(".cpp"); at != std::string::npos && m_buildHints.size() < 200;
         at = text.find(".cpp", at + 4)) {
        std::size_t begin = at;
        while (begin > 0 && (std::isalnum(static_cast<unsigned char>(text[begin - 1])) != 0 ||
                             text[begin - 1] == '_' || text[begin - 1] == '-')) {
            --begin;
        }
        const bool whole =
            at + 4 == text.size() || std::isalnum(static_cast<unsigned char>(text[at + 4])) == 0;
        if (begin < at && whole) {
            m_buildHints.push_back(text.substr(begin, at + 4 - begin));
        }
    }
}

/// Sources below `p1_NIP/` when those of this assignment are there too.
void Sorting::ignoreOtherAssignments() {
    const auto assignment = [](const SubmittedFile &file) {
        std::string found;
        for (const std::string &folder : splitPath(file.path).folders) {
            if (const NamedMembers named = parseMembers(folder); !named.assignment.empty()) {
                found = named.assignment;
            }
        }
        return found;
    };
    const bool anyOfThis = std::any_of(
        m_submission.files.begin(), m_submission.files.end(), [&](const SubmittedFile &file) {
            return file.role == FileRole::Source && assignment(file) == "p2";
        });
    for (SubmittedFile &file : m_submission.files) {
        const std::string other = assignment(file);
        if (anyOfThis && !other.empty() && other != "p2" && file.role != FileRole::Ignored) {
            file.role = FileRole::Ignored;
            file.reason = fmt::format("lies in the folder of another assignment, {}", other);
            note(Note::Level::Odd, file.path,
                 fmt::format("'{}' was not used: it {}.", shortened(file.path), file.reason));
        }
    }
}

void Sorting::noteOwned() {
    if (!m_owned.empty()) {
        note(Note::Level::Odd, "",
             fmt::format("Not used, because the base's own are built: {}. What was changed in them "
                         "has no effect here.",
                         fmt::join(m_owned, ", ")));
    }
}

void Sorting::keepOneReadme() {
    SubmittedFile *best = nullptr;
    const auto depth = [](const SubmittedFile &file) {
        return std::count(file.path.begin(), file.path.end(), '/');
    };
    for (SubmittedFile &file : m_submission.files) {
        if (file.role == FileRole::Readme && (best == nullptr || depth(file) < depth(*best))) {
            best = &file;
        }
    }
    for (SubmittedFile &file : m_submission.files) {
        if (file.role == FileRole::Readme && &file != best) {
            file.role = FileRole::Ignored;
            file.reason = fmt::format("a README beside '{}'", best->path);
            note(Note::Level::Info, file.path,
                 fmt::format("There are several READMEs; '{}' is the one that is shown.",
                             best->path));
        }
    }
}

void Sorting::noteBuildHints() {
    std::vector<std::string> missing;
    for (const std::string &name : m_buildHints) {
        const bool handedIn = std::any_of(
            m_submission.files.begin(), m_submission.files.end(), [&](const SubmittedFile &file) {
                return lowerAscii(splitPath(file.path).name) == lowerAscii(name);
            });
        const bool told = std::find(missing.begin(), missing.end(), name) != missing.end();
        if (!handedIn && !told && !findBaseName(name)) {
            missing.push_back(name);
        }
    }
    if (!missing.empty()) {
        note(Note::Level::Odd, "",
             fmt::format("The CMakeLists.txt names sources that were not handed in: {}.",
                         fmt::join(missing, ", ")));
    }
}

void Sorting::finish() {
    std::sort(m_submission.files.begin(), m_submission.files.end(),
              [](const SubmittedFile &a, const SubmittedFile &b) { return a.path < b.path; });
    ignoreOtherAssignments();
    keepOneOfEach(m_submission);
    sortExtras(m_submission);
    keepOneReadme();
    noteOwned();
    noteBuildHints();
}

} // namespace

void sortFiles(const std::vector<RawFile> &raw, Submission &submission) {
    Sorting sorting(submission);
    for (const RawFile &file : raw) {
        sorting.add(file);
    }
    sorting.finish();
}

} // namespace grader
