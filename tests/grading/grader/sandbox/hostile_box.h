// SPDX-License-Identifier: MIT
#pragma once

#include <grader/sandbox/cgroup.h>

#include <gtest/gtest.h>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace grader {

inline std::string wholeFile(const std::filesystem::path &file) {
    std::ifstream stream(file);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// Processes whose command line holds `marker`.
inline int processesMarked(const std::string &marker) {
    int count = 0;
    for (const auto &entry : std::filesystem::directory_iterator("/proc")) {
        const std::string name = entry.path().filename().string();
        const bool process = std::all_of(name.begin(), name.end(),
                                         [](unsigned char c) { return std::isdigit(c) != 0; });
        if (process && wholeFile(entry.path() / "cmdline").find(marker) != std::string::npos)
            ++count;
    }
    return count;
}

/// Control groups that `process` has made and that are still there.
inline int controlGroupsOf(pid_t process) {
    static const CgroupPlaces places = findCgroupPlaces();
    const std::string prefix = "norigrade-" + std::to_string(process) + "-";
    int count = 0;
    for (const auto &place : {places.memory, places.pids}) {
        std::error_code none; // no such place: no groups
        for (const auto &entry : std::filesystem::directory_iterator(place, none))
            count += entry.path().filename().string().rfind(prefix, 0) == 0 ? 1 : 0;
    }
    return count;
}

inline long openDescriptors() {
    const std::filesystem::directory_iterator entries("/proc/self/fd");
    return std::distance(begin(entries), end(entries));
}

/// True if this process has a child, be it a dead one that nobody has waited for.
inline bool hasChild() {
    siginfo_t info{};
    return ::waitid(P_ALL, 0, &info, WEXITED | WNOHANG | WNOWAIT) == 0 || errno != ECHILD;
}

/// A folder that the box's user can search (the build tree may lie below /root), holding a program
/// to lock in and a file that must stay as it is.
class HostileBox : public ::testing::Test {
protected:
    void SetUp() override {
        std::string pattern = "/tmp/norigrade-hostile-XXXXXX";
        ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
        m_folder = pattern;
        ::chmod(m_folder.c_str(), 0755);
        m_marker = m_folder.filename().string();
        std::ofstream(sentinel()) << "untouched";
        ::chmod(sentinel().c_str(), 0666);
    }

    void TearDown() override {
        EXPECT_EQ(processesMarked(m_marker), 0);
        EXPECT_FALSE(hasChild());
        EXPECT_EQ(controlGroupsOf(::getpid()), 0);
        EXPECT_EQ(wholeFile(sentinel()), "untouched");
        std::filesystem::remove_all(m_folder);
    }

    std::filesystem::path sentinel() const { return m_folder / "sentinel"; }

    /// Copies a program there.
    std::filesystem::path place(const std::filesystem::path &program) const {
        const std::filesystem::path placed = m_folder / program.filename();
        std::filesystem::copy_file(program, placed, std::filesystem::copy_options::skip_existing);
        return placed;
    }

    std::filesystem::path m_folder;
    std::string m_marker;
};

/// `hostile MODE` in a box with limits that are soon reached.
inline BoxSpec hostileSpec(const std::filesystem::path &program, const std::string &mode,
                           const std::string &marker) {
    BoxSpec spec;
    spec.argv = {"/hostile", mode, marker};
    spec.binds = {{program, "/hostile", false},
                  {program.parent_path() / "sentinel", "/sentinel", false}};
    spec.limits.cpu = std::chrono::seconds(1);
    spec.limits.wall = std::chrono::seconds(10);
    spec.limits.memoryBytes = std::uint64_t{128} << 20;
    spec.limits.temporaryBytes = std::uint64_t{16} << 20;
    spec.limits.fileBytes = std::uint64_t{8} << 20;
    spec.limits.logBytes = std::uint64_t{1} << 20;
    spec.limits.processes = 24;
    return spec;
}

} // namespace grader
