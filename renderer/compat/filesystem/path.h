// SPDX-License-Identifier: MIT
// File names under the interface that Nori's code calls. Plain POSIX rather than <filesystem>:
// submissions write `using namespace std`, and std::filesystem would make the name ambiguous.
#pragma once

#include <limits.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <ostream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace filesystem {

class path {
public:
    path() = default;

    path(const char *text) : m_text(text) { trim(); }

    path(const std::string &text) : m_text(text) { trim(); }

    bool empty() const { return m_text.empty(); }

    bool is_absolute() const { return !m_text.empty() && m_text[0] == '/'; }

    bool exists() const {
        struct stat info;
        return status(info);
    }

    bool is_directory() const {
        struct stat info;
        return status(info) && S_ISDIR(info.st_mode);
    }

    bool is_file() const {
        struct stat info;
        return status(info) && S_ISREG(info.st_mode);
    }

    size_t file_size() const {
        struct stat info;
        if (!status(info))
            throw std::runtime_error("path::file_size(): cannot stat file \"" + m_text + "\"!");
        return static_cast<size_t>(info.st_size);
    }

    /// Throws std::runtime_error if the file does not exist.
    path make_absolute() const {
        char *resolved = ::realpath(m_text.c_str(), nullptr);
        if (resolved == nullptr)
            throw std::runtime_error(m_text + ": " + std::generic_category().message(errno));
        const path result(resolved);
        ::free(resolved);
        return result;
    }

    /// Without the dot; empty if there is none.
    std::string extension() const {
        const std::string name = filename();
        const size_t dot = name.find_last_of('.');
        return dot == std::string::npos ? std::string() : name.substr(dot + 1);
    }

    std::string filename() const {
        const size_t slash = m_text.find_last_of('/');
        return slash == std::string::npos ? m_text : m_text.substr(slash + 1);
    }

    /// ".." of an empty path, the empty path of a bare file name.
    path parent_path() const {
        if (m_text.empty())
            return path("..");
        const size_t slash = m_text.find_last_of('/');
        if (slash == std::string::npos)
            return path();
        return path(slash == 0 ? std::string("/") : m_text.substr(0, slash));
    }

    /// Throws std::runtime_error if `other` is absolute.
    path operator/(const path &other) const {
        if (other.is_absolute())
            throw std::runtime_error("path::operator/(): expected a relative path!");
        if (m_text.empty() || other.m_text.empty())
            return path(m_text + other.m_text);
        return path((m_text == "/" ? m_text : m_text + "/") + other.m_text);
    }

    std::string str() const { return m_text; }

    void set(const std::string &text) { *this = path(text); }

    bool remove_file() const { return ::unlink(m_text.c_str()) == 0; }

    static path getcwd() {
        char buffer[PATH_MAX];
        if (::getcwd(buffer, sizeof buffer) == nullptr)
            throw std::runtime_error("path::getcwd(): the working directory is not readable!");
        return path(buffer);
    }

    bool operator==(const path &other) const { return m_text == other.m_text; }

    bool operator!=(const path &other) const { return m_text != other.m_text; }

    friend std::ostream &operator<<(std::ostream &out, const path &p) { return out << p.m_text; }

private:
    bool status(struct stat &info) const { return ::stat(m_text.c_str(), &info) == 0; }

    void trim() {
        while (m_text.size() > 1 && m_text.back() == '/')
            m_text.pop_back();
    }

    std::string m_text;
};

} // namespace filesystem
