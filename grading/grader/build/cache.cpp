// SPDX-License-Identifier: MIT
#include "cache.h"

#include <grader/digest.h>
#include <grader/error.h>
#include <grader/text_file.h>

#include <fmt/core.h>

#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>

namespace grader {

namespace {

/// The first folder above `path` that other users cannot search; empty if there is none.
std::filesystem::path closedFolderAbove(const std::filesystem::path &path) {
    std::filesystem::path folder;
    for (const auto &part : std::filesystem::absolute(path)) {
        folder /= part;

        struct stat status {};

        if (::stat(folder.c_str(), &status) == 0 && (status.st_mode & S_IXOTH) == 0)
            return folder;
    }
    return {};
}

} // namespace

std::filesystem::path Cache::defaultRoot() {
    if (const char *chosen = std::getenv("NORIGRADE_CACHE"))
        return chosen;
    if (::geteuid() == 0)
        return "/var/cache/norigrade";
    if (const char *cache = std::getenv("XDG_CACHE_HOME"))
        return std::filesystem::path(cache) / "norigrade";
    const char *home = std::getenv("HOME");
    if (home == nullptr)
        throw GraderError("HOME is not set; name a folder for built files in NORIGRADE_CACHE");
    return std::filesystem::path(home) / ".cache" / "norigrade";
}

Cache::Cache(std::filesystem::path root) : m_root(std::move(root)) {
    std::error_code error;
    std::filesystem::create_directories(m_root, error);
    if (error || ::access(m_root.c_str(), W_OK) != 0)
        throw GraderError(fmt::format("{}: cannot be written; name another folder for built files "
                                      "in NORIGRADE_CACHE",
                                      m_root.string()));
    // As root, boxes run as another user, who has to reach the files.
    const std::filesystem::path closed = closedFolderAbove(m_root);
    if (::geteuid() == 0 && !closed.empty())
        throw GraderError(
            fmt::format("{}: the folder {} above it is closed to other users, as whom "
                        "submissions run; name another one in NORIGRADE_CACHE",
                        m_root.string(), closed.string()));
}

std::filesystem::path Cache::entry(const std::string &kind, const std::string &digest,
                                   const std::string &suffix) const {
    return m_root / kind / digest.substr(0, 2) / (digest.substr(2) + suffix);
}

std::filesystem::path Cache::install(const std::filesystem::path &program) const {
    const std::string bytes = readTextFile(program);
    std::filesystem::path file = entry("executables", sha256Hex(bytes));
    if (!std::filesystem::exists(file)) {
        writeTextFile(file, bytes);
        using std::filesystem::perms;
        std::filesystem::permissions(file,
                                     perms::owner_exec | perms::group_exec | perms::others_exec,
                                     std::filesystem::perm_options::add);
    }
    return file;
}

std::filesystem::path Cache::makeScratch() const {
    std::string pattern = (m_root / "scratch-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr)
        throw GraderError(fmt::format("{}: no folder can be made in it", m_root.string()));
    ::chmod(pattern.c_str(), 0777);
    return pattern;
}

} // namespace grader
