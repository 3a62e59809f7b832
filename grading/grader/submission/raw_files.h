// SPDX-License-Identifier: MIT
#pragma once

#include <grader/error.h>
#include <grader/results/results.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

/// The contents of a hand-in before anything is made of them.
namespace grader {

/// What a hand-in may cost us. Sizes are of what was really unpacked, never of what a header says.
struct ReadLimits {
    std::size_t files = 2000;             ///< files that are read, nested archives included
    std::size_t entries = 40000;          ///< entries, including those in folders that are left out
    std::uint64_t fileBytes = 64U << 20U; ///< a larger file is left out
    std::uint64_t totalBytes = 512U << 20U;
    std::uint64_t ratio = 200;              ///< unpacked : packed size of one archive, ...
    std::uint64_t ratioFrom = 10U << 20U;   ///< ... once it has given this many bytes
    int archiveDepth = 2;                   ///< archives within the outermost one
    std::chrono::milliseconds time{30'000}; ///< wall clock for the whole hand-in
};

/// A hand-in broke a limit: it is refused as a whole.
class LimitError : public GraderError {
public:
    using GraderError::GraderError;
};

/// What has been spent of the limits so far. Each call throws LimitError when one is passed.
class ReadBudget {
public:
    ReadBudget(ReadLimits limits, std::string subject);

    const ReadLimits &limits() const { return m_limits; }

    void countEntry();
    void countFile();
    void countKeptBytes(std::uint64_t bytes);
    void checkTime() const;
    /// `unpacked` bytes came out of an archive of `packed` bytes, at entry `where`.
    void checkRatio(std::uint64_t unpacked, std::uint64_t packed, const std::string &where) const;

private:
    [[noreturn]] void refuse(const std::string &what) const;

    ReadLimits m_limits;
    std::string m_subject;
    std::size_t m_entries = 0;
    std::size_t m_files = 0;
    std::uint64_t m_keptBytes = 0;
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

/// One file as found. `refused` is empty for a file that was read; else it says why there are no
/// `bytes`, as the file's reason in the list of files.
struct RawFile {
    std::string path; ///< UTF-8 (NFC) once decodeNames() has run; `/` separates
    std::string bytes;
    std::string refused;
};

struct RawFiles {
    std::vector<RawFile> files;
    std::vector<Note> notes;
};

class LeftOutFolders;

/// Last step of reading: makes a note of each file that was refused, lists the folders that were
/// left out, and decodes the names of all, in one charset.
void finishFiles(RawFiles &read, const LeftOutFolders &leftOut);

} // namespace grader
