// SPDX-License-Identifier: MIT
#include "host.h"

#include <grader/digest.h>

#include <fmt/format.h>

#include <cstdlib>
#include <set>
#include <stdexcept>

#include "../grading/grader/sandbox/hostile_box.h"

namespace attack {

namespace {

namespace fs = std::filesystem;

std::set<std::string> linesOf(const std::string &text) {
    std::istringstream stream(text);
    std::set<std::string> lines;
    for (std::string line; std::getline(stream, line);)
        lines.insert(line);
    return lines;
}

/// How many lines are in one of the texts only.
int differingLines(const std::string &a, const std::string &b) {
    const std::set<std::string> left = linesOf(a);
    const std::set<std::string> right = linesOf(b);
    std::set<std::string> all = left;
    all.insert(right.begin(), right.end());
    return static_cast<int>(2 * all.size() - left.size() - right.size());
}

} // namespace

Traces &Traces::operator+=(const Traces &other) {
    processes += other.processes;
    controlGroups += other.controlGroups;
    mounts += other.mounts;
    files += other.files;
    descriptors += other.descriptors;
    return *this;
}

std::string Traces::describe() const {
    return fmt::format("{} host files changed, {} processes, {} control groups, {} mounts and {} "
                       "descriptors left",
                       files, processes, controlGroups, mounts, descriptors);
}

Host::Host(std::initializer_list<const char *> programs) {
    std::string pattern = "/tmp/norigrade-attack-XXXXXX";
    if (::mkdtemp(pattern.data()) == nullptr)
        throw std::runtime_error("no temporary folder");
    m_folder = pattern;
    fs::create_directories(inbox());
    for (const char *file : {"sentinel", "tree/secret", "tree/grades/results.json", "tree/warp.cpp",
                             "tree/in/src/warp.cpp", "tree/in/box/notes.txt"}) {
        fs::create_directories((m_folder / file).parent_path());
        std::ofstream(m_folder / file) << kSecret << "\n";
    }
    for (const auto &entry : fs::recursive_directory_iterator(m_folder))
        ::chmod(entry.path().c_str(), entry.is_directory() ? 0777 : 0666);
    ::chmod(m_folder.c_str(), 0755);
    for (const char *program : programs)
        fs::copy_file(program, place(program));
}

Host::~Host() {
    std::error_code ignored;
    fs::remove_all(m_folder, ignored);
}

std::string Host::digestOfFiles() const {
    std::string all;
    std::set<fs::path> files{m_folder / "sentinel", m_folder / "tree"};
    for (const auto &entry : fs::recursive_directory_iterator(m_folder / "tree"))
        files.insert(entry.path());
    for (const fs::path &file : files) {
        struct stat status {};

        ::lstat(file.c_str(), &status);
        all += fmt::format("{} {} {} {} {} {}\n", file.string(), status.st_mode, status.st_uid,
                           status.st_mtim.tv_sec, status.st_mtim.tv_nsec,
                           fs::is_regular_file(file) ? grader::wholeFile(file) : std::string());
    }
    return grader::sha256Hex(all);
}

Host::State Host::state() const {
    return {digestOfFiles(), grader::wholeFile("/proc/self/mountinfo"), grader::openDescriptors()};
}

Traces Host::tracesSince(const State &before) const {
    Traces traces;
    traces.processes = grader::processesMarked(marker()) + (grader::hasChild() ? 1 : 0);
    traces.controlGroups = grader::controlGroupsOf(::getpid());
    traces.mounts = differingLines(before.mounts, grader::wholeFile("/proc/self/mountinfo"));
    traces.files = digestOfFiles() == before.files ? 0 : 1;
    traces.descriptors = static_cast<int>(std::abs(grader::openDescriptors() - before.descriptors));
    return traces;
}

} // namespace attack
