// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace attack {

constexpr char kSecret[] = "secret 3141592653"; ///< in each sentinel

/// What an attacker has left behind; nothing may be.
struct Traces {
    int processes = 0;
    int controlGroups = 0;
    int mounts = 0; ///< that came or went
    int files = 0;  ///< 1 if the sentinel tree is another
    int descriptors = 0;

    int all() const { return processes + controlGroups + mounts + files + descriptors; }

    Traces &operator+=(const Traces &other);
    /// `0 processes, 0 control groups, ...`
    std::string describe() const;
};

/// The machine as an attacker must leave it: a folder with its program and a sentinel tree, which
/// everybody may write, and what this process has.
class Host {
public:
    /// \param programs  copied to where the users of boxes can reach them
    /// \throws std::runtime_error  without a temporary folder
    explicit Host(std::initializer_list<const char *> programs);
    ~Host();

    Host(const Host &) = delete;
    Host &operator=(const Host &) = delete;
    Host(Host &&) = delete;
    Host &operator=(Host &&) = delete;

    std::filesystem::path place(const std::filesystem::path &program) const {
        return m_folder / program.filename();
    }

    /// A folder deep in the sentinel tree, for archives.
    std::filesystem::path inbox() const { return m_folder / "tree/in/box"; }

    std::filesystem::path secretFile() const { return m_folder / "tree/secret"; }

    /// Stands in the command line of everything that is started from the folder.
    std::string marker() const { return m_folder.filename().string(); }

    /// How it is now, to compare later.
    struct State {
        std::string files; ///< digest of names, contents, owners, rights and times
        std::string mounts;
        long descriptors = 0;
    };

    State state() const;
    Traces tracesSince(const State &before) const;

private:
    std::string digestOfFiles() const;

    std::filesystem::path m_folder;
};

} // namespace attack
