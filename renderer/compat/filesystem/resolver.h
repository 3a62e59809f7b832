// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem/path.h>

#include <vector>

namespace filesystem {

/// Looks for files in a list of folders, in order; at first only in the working directory.
class resolver {
public:
    typedef std::vector<path>::iterator iterator;
    typedef std::vector<path>::const_iterator const_iterator;

    resolver() { m_paths.push_back(path::getcwd()); }

    size_t size() const { return m_paths.size(); }

    iterator begin() { return m_paths.begin(); }

    iterator end() { return m_paths.end(); }

    const_iterator begin() const { return m_paths.begin(); }

    const_iterator end() const { return m_paths.end(); }

    void erase(iterator it) { m_paths.erase(it); }

    void prepend(const path &folder) { m_paths.insert(m_paths.begin(), folder); }

    void append(const path &folder) { m_paths.push_back(folder); }

    /// The first existing file of this name, or `value` itself if there is none.
    path resolve(const path &value) const {
        if (value.is_absolute())
            return value;
        for (const path &folder : m_paths) {
            const path candidate = folder / value;
            if (candidate.exists())
                return candidate;
        }
        return value;
    }

private:
    std::vector<path> m_paths;
};

} // namespace filesystem
