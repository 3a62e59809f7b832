// SPDX-License-Identifier: MIT
#include "machine.h"

#include <fmt/format.h>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <thread>

#include "expectation.h"

namespace exam {

namespace {

namespace fs = std::filesystem;

struct Process {
    pid_t id = 0;
    std::string name;
};

/// The process of /proc/<id>, if we are its parent and it has not ended.
std::optional<Process> childOfOurs(const fs::path &folder) {
    const std::string id = folder.filename().string();
    if (!std::all_of(id.begin(), id.end(), [](unsigned char c) { return std::isdigit(c) != 0; }))
        return std::nullopt;
    std::ifstream stream(folder / "stat");
    std::string text;
    std::getline(stream, text);
    // "1234 (name) S 1 ...": the name may hold anything, also brackets
    const std::size_t open = text.find('(');
    const std::size_t close = text.rfind(')');
    if (open == std::string::npos || close == std::string::npos || close + 4 > text.size())
        return std::nullopt; // it has ended meanwhile
    const char state = text[close + 2];
    const int parent = std::atoi(text.c_str() + close + 4); // NOLINT(cert-err34-c): the kernel's
    if (parent != getpid() || state == 'Z')
        return std::nullopt;
    return Process{std::atoi(id.c_str()),
                   text.substr(open, close - open + 1)}; // NOLINT(cert-err34-c)
}

std::vector<Process> children() {
    while (waitpid(-1, nullptr, WNOHANG) > 0) { // orphans that have ended
    }
    std::vector<Process> result;
    std::error_code ignored; // processes come and go
    for (const auto &entry : fs::directory_iterator("/proc", ignored)) {
        if (auto process = childOfOurs(entry.path()))
            result.push_back(*process);
    }
    return result;
}

} // namespace

void adoptOrphans() {
    if (prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0) != 0)
        throw ExamError(fmt::format("cannot adopt orphans: {}", std::strerror(errno)));
}

std::vector<std::string> killLeftProcesses() {
    using namespace std::chrono_literals;
    std::vector<Process> left = children();
    for (int round = 0; round < 20 && !left.empty(); ++round) {
        std::this_thread::sleep_for(50ms);
        left = children();
    }
    std::vector<std::string> names;
    for (const Process &process : left) {
        names.push_back(fmt::format("{} {}", process.id, process.name));
        kill(process.id, SIGKILL);
    }
    return names;
}

Snapshot takeSnapshot(const fs::path &folder) {
    Snapshot snapshot;
    for (const auto &entry : fs::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file())
            continue;
        std::ifstream stream(entry.path(), std::ios::binary);
        snapshot[entry.path().string()].assign(std::istreambuf_iterator<char>(stream), {});
    }
    return snapshot;
}

std::vector<std::string> differences(const Snapshot &before, const Snapshot &after) {
    std::vector<std::string> result;
    for (const auto &[file, bytes] : before) {
        const auto now = after.find(file);
        if (now == after.end())
            result.push_back(file + " is gone");
        else if (now->second != bytes)
            result.push_back(file + " has changed");
    }
    for (const auto &[file, bytes] : after) {
        if (before.count(file) == 0)
            result.push_back(file + " is new");
    }
    return result;
}

std::vector<fs::path> leftFiles(const std::vector<std::string> &names, const fs::path &more) {
    std::vector<fs::path> found;
    for (const fs::path &folder : {fs::path("/"), fs::path("/tmp"), fs::path("/var/tmp"),
                                   fs::path("/dev/shm"), fs::current_path(), more}) {
        for (const std::string &name : names) {
            if (fs::exists(folder / name))
                found.push_back(folder / name);
        }
    }
    return found;
}

} // namespace exam
