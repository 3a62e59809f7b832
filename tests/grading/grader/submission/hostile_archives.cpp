// SPDX-License-Identifier: MIT
#include "hostile_archives.h"

#include <grader/error.h>
#include <grader/submission/names.h>

#include <fmt/format.h>

#include <chrono>
#include <fstream>

namespace grader::test {

namespace {

constexpr double kTime = 10;          ///< [s]; the reader's own limit is 30
constexpr long kMemory = 700L << 10U; ///< [KiB]; what is kept may be 512 MiB

/// A figure of /proc/self/status [KiB].
long memoryOf(const std::string &key) {
    std::ifstream lines("/proc/self/status");
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind(key, 0) == 0)
            return std::atol(line.c_str() + key.size());
    }
    return 0;
}

/// What is wrong with what was read, but for bounds.
std::string faultOf(const HostileArchive &archive, const Submission &submission) {
    std::string said;
    for (const Note &note : submission.notes)
        said += note.file + ": " + note.text + "\n";
    bool honest = false;
    for (const SubmittedFile &file : submission.files) {
        said += file.path + ": " + file.reason + "\n";
        if (!isUtf8(file.path))
            return "a path is no UTF-8: " + file.path;
        if (file.role != FileRole::Ignored && !pathFault(file.path).empty())
            return "a hostile path is used: " + file.path;
        honest = honest || (file.path == "src/mesh.cpp" && file.role == FileRole::Source &&
                            file.bytes == "// mesh\n");
    }
    if (said.find(archive.said) == std::string::npos)
        return fmt::format("\"{}\" is not in\n{}", archive.said, said);
    if (honest != archive.honest)
        return (honest ? "its file is taken:\n" : "its honest file is not taken:\n") + said;
    return {};
}

} // namespace

ReadArchive readHostileArchive(const HostileArchive &archive, const std::filesystem::path &file) {
    ReadArchive read;
    std::ofstream("/proc/self/clear_refs") << 5; // the high-water mark starts anew
    [[maybe_unused]] const long memory = memoryOf("VmRSS:");
    const auto start = std::chrono::steady_clock::now();
    try {
        read.submission = readSubmission(file);
    } catch (const GraderError &error) {
        read.error = error.what();
    }
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    if (time.count() > kTime)
        read.fault = fmt::format("reading it takes {:.1f} s", time.count());
#ifndef __SANITIZE_ADDRESS__ // which keeps what was freed
    else if (memoryOf("VmHWM:") - memory > kMemory)
        read.fault = fmt::format("reading it takes {} KiB", memoryOf("VmHWM:") - memory);
#endif
    else if (archive.refused == nullptr)
        read.fault = read.error.empty() ? faultOf(archive, read.submission) : read.error;
    else if (read.error.find(archive.refused) == std::string::npos)
        read.fault = "is not refused as it must be: " + read.error;
    return read;
}

} // namespace grader::test
