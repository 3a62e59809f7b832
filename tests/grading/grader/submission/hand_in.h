// SPDX-License-Identifier: MIT
#pragma once

#include <grader/submission/reading.h>
#include <grader/submission/submission.h>

#include <archive.h>
#include <archive_entry.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <utility>
#include <vector>

/// Hand-ins made for tests.
namespace grader::test {

/// A folder that is gone after the test.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "hand-in-XXXXXX").string();
        if (mkdtemp(pattern.data()) == nullptr) {
            throw std::runtime_error("no temporary folder");
        }
        m_path = pattern;
    }

    ~TemporaryFolder() { std::filesystem::remove_all(m_path); }

    TemporaryFolder(const TemporaryFolder &) = delete;
    TemporaryFolder &operator=(const TemporaryFolder &) = delete;
    TemporaryFolder(TemporaryFolder &&) = delete;
    TemporaryFolder &operator=(TemporaryFolder &&) = delete;

    const std::filesystem::path &path() const { return m_path; }

    std::filesystem::path write(const std::string &name, const std::string &bytes) const {
        std::filesystem::path path = m_path / name;
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << bytes;
        return path;
    }

private:
    std::filesystem::path m_path;
};

using Files = std::vector<std::pair<std::string, std::string>>;

/// An archive in memory, made by libarchive. `prepare` may set what a plain file has not.
inline std::string makeArchive(
    int format, const Files &files,
    const std::function<void(archive_entry *)> &prepare = [](archive_entry *) {}) {
    std::size_t room = 1U << 16U;
    for (const auto &[name, content] : files) {
        room += content.size() + 4 * name.size() + 2048; // headers, and a tar's padding
    }
    std::string bytes(room, '\0');
    std::size_t used = 0;
    archive *writer = archive_write_new();
    archive_write_set_format(writer, format);
    archive_write_add_filter_none(writer);
    archive_write_set_bytes_in_last_block(writer, 1);
    archive_write_open_memory(writer, bytes.data(), bytes.size(), &used);
    for (const auto &[name, content] : files) {
        archive_entry *entry = archive_entry_new();
        archive_entry_copy_pathname(entry, name.c_str());
        archive_entry_set_filetype(entry, AE_IFREG);
        archive_entry_set_perm(entry, 0644);
        archive_entry_set_size(entry, static_cast<la_int64_t>(content.size()));
        prepare(entry);
        archive_write_header(writer, entry);
        if (archive_entry_size(entry) > 0) {
            archive_write_data(writer, content.data(), content.size());
        }
        archive_entry_free(entry);
    }
    archive_write_close(writer);
    archive_write_free(writer);
    bytes.resize(used);
    return bytes;
}

inline std::string makeZip(const Files &files) {
    return makeArchive(ARCHIVE_FORMAT_ZIP, files);
}

/// Reads `bytes` as a file called `name`.
inline Submission readBytes(const std::string &bytes,
                            const std::string &name = "p2_111111_222222.zip",
                            const ReadLimits &limits = {}) {
    const TemporaryFolder folder;
    return readSubmission(folder.write(name, bytes), limits);
}

inline Submission readZip(const Files &files, const std::string &name = "p2_111111_222222.zip") {
    return readBytes(makeZip(files), name);
}

inline const SubmittedFile *findPath(const Submission &submission, const std::string &path) {
    for (const SubmittedFile &file : submission.files) {
        if (file.path == path) {
            return &file;
        }
    }
    return nullptr;
}

/// The role and reason of a path, for a message that shows both.
inline FileRole roleOf(const Submission &submission, const std::string &path) {
    const SubmittedFile *file = findPath(submission, path);
    if (file == nullptr) {
        ADD_FAILURE() << "no file '" << path << "'";
        for (const SubmittedFile &each : submission.files) {
            ADD_FAILURE() << "  there is '" << each.path << "'";
        }
        return FileRole::Ignored;
    }
    return file->role;
}

inline bool hasNote(const Submission &submission, Note::Level level, const std::string &part) {
    for (const Note &note : submission.notes) {
        if (note.level == level && note.text.find(part) != std::string::npos) {
            return true;
        }
    }
    return false;
}

inline std::string allNotes(const Submission &submission) {
    std::string text;
    for (const Note &note : submission.notes) {
        text += note.file + ": " + note.text + "\n";
    }
    return text;
}

inline std::string messageOf(const std::function<void()> &action) {
    try {
        action();
    } catch (const GraderError &error) {
        return error.what();
    }
    return "(nothing was thrown)";
}

} // namespace grader::test
