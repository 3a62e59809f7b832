// SPDX-License-Identifier: MIT
#include <grader/submission/clutter.h>
#include <grader/submission/names.h>
#include <grader/submission/raw_files.h>

#include <fmt/format.h>

#include <utility>

namespace grader {

namespace {

constexpr std::uint64_t kMiB = 1U << 20U;

}

ReadBudget::ReadBudget(ReadLimits limits, std::string subject)
    : m_limits(limits), m_subject(std::move(subject)) {}

void ReadBudget::countEntry() {
    checkTime();
    if (++m_entries > m_limits.entries) {
        refuse(fmt::format("has more than {} entries", m_limits.entries));
    }
}

void ReadBudget::countFile() {
    if (++m_files > m_limits.files) {
        refuse(fmt::format("has more than {} files, not counting build folders", m_limits.files));
    }
}

void ReadBudget::countKeptBytes(std::uint64_t bytes) {
    m_keptBytes += bytes;
    if (m_keptBytes > m_limits.totalBytes) {
        refuse(fmt::format("unpacks to more than {} MiB", m_limits.totalBytes / kMiB));
    }
}

void ReadBudget::checkTime() const {
    if (std::chrono::steady_clock::now() - m_start > m_limits.time) {
        refuse(fmt::format("takes more than {} s to read",
                           std::chrono::duration<double>(m_limits.time).count()));
    }
}

void ReadBudget::checkRatio(std::uint64_t unpacked, std::uint64_t packed,
                            const std::string &where) const {
    if (unpacked > m_limits.ratioFrom && unpacked / m_limits.ratio > packed) {
        refuse(
            fmt::format("unpacks to more than {} times its size, at '{}'", m_limits.ratio, where));
    }
}

void ReadBudget::refuse(const std::string &what) const {
    throw LimitError(fmt::format("{}: {}; unpack it by hand, look at it, and grade a folder with "
                                 "only the files that belong to the assignment",
                                 m_subject, what));
}

void finishFiles(RawFiles &read, const LeftOutFolders &leftOut) {
    const std::size_t refusable = read.files.size();
    leftOut.appendTo(read.files);
    std::vector<std::string> names;
    for (const RawFile &file : read.files) {
        names.push_back(file.path);
    }
    names = decodeNames(names);
    for (std::size_t i = 0; i < names.size(); ++i) {
        RawFile &file = read.files[i];
        file.path = names[i].empty() ? "(no name)" : shortened(names[i], 1024);
        if (i < refusable && !file.refused.empty()) {
            file.bytes.clear();
            read.notes.push_back(
                {Note::Level::Human, file.path,
                 fmt::format("'{}' {}: not read.", shortened(file.path), file.refused)});
            file.refused += ": not read";
        }
    }
}

} // namespace grader
