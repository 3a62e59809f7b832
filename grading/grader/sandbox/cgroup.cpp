// SPDX-License-Identifier: MIT
#include "cgroup.h"

#include <grader/error.h>

#include <fmt/core.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <set>
#include <sstream>
#include <thread>
#include <utility>

namespace grader {

namespace {

using std::filesystem::path;

constexpr char kRoot[] = "/sys/fs/cgroup"; // a Sandbox may be made before main()
constexpr char kPrefix[] = "norigrade-";

bool writeFile(const path &file, const std::string &text) {
    std::ofstream stream(file);
    stream << text;
    stream.flush();
    return static_cast<bool>(stream);
}

std::string readFile(const path &file) {
    std::ifstream stream(file);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// Makes a group below `folder` under a name that nobody else has. \return  empty if refused
path makeGroup(const path &folder) {
    static std::atomic<unsigned> counter{0};
    for (;;) {
        path group = folder / fmt::format("{}{}-{}", kPrefix, ::getpid(), counter++);
        if (::mkdir(group.c_str(), 0755) == 0)
            return group;
        if (errno != EEXIST)
            return {};
    }
}

/// Kills what is in a group. \return  true if there was something
bool killMembers(const path &group) {
    std::istringstream text(readFile(group / "cgroup.procs"));
    bool any = false;
    for (pid_t process = 0; text >> process; any = true)
        ::kill(process, SIGKILL);
    return any;
}

/// Removes the groups of graders that were themselves killed.
void sweep(const path &folder) {
    std::error_code error;
    for (const auto &entry : std::filesystem::directory_iterator(folder, error)) {
        const std::string name = entry.path().filename().string();
        if (name.rfind(kPrefix, 0) != 0)
            continue;
        const pid_t owner = std::atoi(name.c_str() + std::strlen(kPrefix));
        if (owner <= 0 || ::kill(owner, 0) == 0 || errno != ESRCH)
            continue;
        killMembers(entry.path());
        ::rmdir(entry.path().c_str()); // if it is still busy, the next run tries again
    }
}

/// True if groups can be made below `folder` that have the file `needed`.
bool canMakeGroups(const path &folder, const char *needed) {
    sweep(folder);
    const path trial = makeGroup(folder);
    if (trial.empty())
        return false;
    const bool has = std::filesystem::exists(trial / needed);
    ::rmdir(trial.c_str());
    return has;
}

/// Version 2 lets a group share out memory only if no process is in it itself, and ours is: so the
/// nearest group above it that can is looked for, too.
path placeOfVersion2(path folder) {
    for (;; folder = folder.parent_path()) {
        if (!canMakeGroups(folder, "memory.max"))
            writeFile(folder / "cgroup.subtree_control", "+memory +pids");
        if (canMakeGroups(folder, "memory.max") && canMakeGroups(folder, "pids.max"))
            return folder;
        if (folder == kRoot || folder == folder.parent_path())
            return {};
    }
}

} // namespace

CgroupPlaces findCgroupPlaces() {
    CgroupPlaces places;
    std::istringstream lines(readFile("/proc/self/cgroup"));
    for (std::string line; std::getline(lines, line);) {
        const std::size_t first = line.find(':');
        const std::size_t second = line.find(':', first + 1);
        if (second == std::string::npos)
            continue;
        const std::string controllers = line.substr(first + 1, second - first - 1);
        const path below = line.substr(second + 2);
        if (controllers.empty()) {
            const path folder = placeOfVersion2(below.empty() ? path(kRoot) : path(kRoot) / below);
            if (!folder.empty())
                return {folder, folder, true};
            continue;
        }
        const path folder = path(kRoot) / controllers / below;
        std::istringstream names(controllers);
        for (std::string name; std::getline(names, name, ',');) {
            if (name == "memory" && canMakeGroups(folder, "memory.limit_in_bytes"))
                places.memory = folder;
            if (name == "pids" && canMakeGroups(folder, "pids.max"))
                places.pids = folder;
        }
    }
    return places;
}

Cgroup::Cgroup(const CgroupPlaces &places, const BoxLimits &limits) : Cgroup(places.version2) {
    for (const path &place : std::set<path>{places.memory, places.pids}) {
        path folder = makeGroup(place);
        if (folder.empty())
            throw GraderError(fmt::format("{}: no control group can be made", place.string()));
        m_folders.push_back(std::move(folder));
    }
    for (const path &folder : m_folders) {
        const std::string bytes = std::to_string(limits.memoryBytes);
        const std::pair<const char *, std::string> settings[] = {
            {"memory.limit_in_bytes", bytes},
            {"memory.memsw.limit_in_bytes", bytes},
            {"memory.max", bytes},
            {"memory.swap.max", "0"},
            // bubblewrap itself and the namespace's first process are counted, too.
            {"pids.max", std::to_string(limits.processes + 3)}};
        for (const auto &[file, value] : settings) {
            if (std::filesystem::exists(folder / file) && !writeFile(folder / file, value))
                throw GraderError(
                    fmt::format("{}: it cannot be set to {}", (folder / file).string(), value));
        }
    }
}

std::vector<Descriptor> Cgroup::entrances() const {
    std::vector<Descriptor> entrances;
    for (const path &folder : m_folders) {
        entrances.emplace_back(::open((folder / "cgroup.procs").c_str(), O_WRONLY | O_CLOEXEC));
        if (!entrances.back())
            throw GraderError(fmt::format("{}: a process cannot be put in", folder.string()));
    }
    return entrances;
}

bool Cgroup::ranOutOfMemory() const {
    for (const path &folder : m_folders) {
        std::istringstream text(
            readFile(folder / (m_version2 ? "memory.events" : "memory.oom_control")));
        std::string key;
        long count = 0;
        while (text >> key >> count) {
            if (key == "oom_kill" && count > 0)
                return true;
        }
    }
    return false;
}

void Cgroup::killAll() {
    constexpr int kTries = 500;
    for (int i = 0; i < kTries; ++i) {
        bool empty = true;
        for (const path &folder : m_folders)
            empty = !killMembers(folder) && empty;
        if (empty)
            return;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
}

Cgroup::~Cgroup() {
    killAll();
    for (const path &folder : m_folders) {
        // A group stays busy for a moment after its last process has gone.
        for (int i = 0; i < 100 && ::rmdir(folder.c_str()) != 0; ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

} // namespace grader
