// SPDX-License-Identifier: MIT
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

/// One reader, as libFuzzer (`./run fuzz`) and the replay of kept inputs (CTest) call it. Each file
/// of targets/ is a program of its own.
namespace fuzz {

/// Gives the reader `bytes`. What the reader says of bad input is caught; everything else that
/// leaves it, or a broken promise, is a finding.
void run(std::string_view bytes);

/// Ends the program if a promise of the reader does not hold.
inline void require(bool holds, const char *promise) {
    if (holds)
        return;
    std::fprintf(stderr, "broken promise: %s\n", promise);
    std::abort();
}

/// A file in memory, for readers that want a name.
class ScratchFile {
public:
    ScratchFile() : m_fd(::memfd_create("fuzz", MFD_CLOEXEC)) { require(m_fd >= 0, "memory"); }

    ~ScratchFile() { ::close(m_fd); }

    ScratchFile(const ScratchFile &) = delete;
    ScratchFile &operator=(const ScratchFile &) = delete;
    ScratchFile(ScratchFile &&) = delete;
    ScratchFile &operator=(ScratchFile &&) = delete;

    /// \return  a path that shows `bytes` until the next call
    std::string write(std::string_view bytes) const {
        const bool written =
            ::ftruncate(m_fd, 0) == 0 &&
            ::pwrite(m_fd, bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size());
        require(written, "memory");
        return "/proc/self/fd/" + std::to_string(m_fd);
    }

private:
    int m_fd;
};

/// A folder in memory, for readers that want names of their own in it.
class ScratchFolder {
public:
    ScratchFolder() {
        std::string pattern = "/dev/shm/norigrade-fuzz-XXXXXX";
        require(::mkdtemp(pattern.data()) != nullptr, "a folder in memory");
        m_path = pattern;
    }

    ~ScratchFolder() { std::filesystem::remove_all(m_path); }

    ScratchFolder(const ScratchFolder &) = delete;
    ScratchFolder &operator=(const ScratchFolder &) = delete;
    ScratchFolder(ScratchFolder &&) = delete;
    ScratchFolder &operator=(ScratchFolder &&) = delete;

    const std::filesystem::path &path() const { return m_path; }

private:
    std::filesystem::path m_path;
};

} // namespace fuzz
