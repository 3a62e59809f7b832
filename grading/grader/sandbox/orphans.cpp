// SPDX-License-Identifier: MIT
#include "orphans.h"

#include <grader/sandbox/descriptor.h>
#include <grader/sandbox/launch.h>

#include <sys/syscall.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

namespace grader {

namespace {

/// Empty if the process is gone: it may end while its files are read.
std::string readFile(const std::filesystem::path &file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// What follows `key` on its line of /proc/PID/status.
std::string statusLine(const std::string &process, const std::string &key) {
    std::ifstream lines("/proc/" + process + "/status");
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind(key, 0) == 0)
            return line.substr(key.size());
    }
    return {};
}

/// True for bubblewrap with a box of ours, until it has become the box's program.
bool isBubblewrap(const std::string &process) {
    const std::string commandLine = readFile("/proc/" + process + "/cmdline");
    const std::string start = std::string(kBubblewrap) + '\0';
    return commandLine.rfind(start, 0) == 0 &&
           commandLine.find('\0' + std::string(kBoxHostName) + '\0') != std::string::npos;
}

/// True for a process that has a number in a namespace below ours.
bool isInside(const std::string &process) {
    std::istringstream numbers(statusLine(process, "NSpid:"));
    return std::distance(std::istream_iterator<long>(numbers), {}) > 1;
}

bool isOrphan(const std::string &process) {
    if (!isBubblewrap(process) || !isInside(process))
        return false;
    std::istringstream line(statusLine(process, "PPid:"));
    std::string parent;
    return line >> parent && !isBubblewrap(parent);
}

} // namespace

void killOrphans() {
    std::error_code error;
    for (const auto &entry : std::filesystem::directory_iterator("/proc", error)) {
        const std::string name = entry.path().filename().string();
        const pid_t process = std::atoi(name.c_str());
        if (process <= 0)
            continue;
        // Opened first: then its number cannot pass to another process that is killed instead.
        const Descriptor handle(static_cast<int>(::syscall(SYS_pidfd_open, process, 0)));
        if (handle && isOrphan(name))
            ::syscall(SYS_pidfd_send_signal, handle.get(), SIGKILL, nullptr, 0);
    }
}

} // namespace grader
