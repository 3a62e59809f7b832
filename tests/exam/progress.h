// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>

namespace exam {

/// Tells on a terminal how long the rest will take, in a last line of stderr that is cleared before
/// anything else is printed. For one thread at a time.
class Progress {
public:
    explicit Progress(std::size_t tasks);

    void clear() const;

    /// \param isNew  whether the task took time: what was known already says nothing of the rest
    void add(bool isNew = true);

    std::size_t done() const { return m_done; }

    double seconds() const; ///< since the beginning

private:
    std::size_t m_tasks;
    std::size_t m_done = 0, m_new = 0;
    std::chrono::steady_clock::time_point m_start;
    bool m_terminal;
};

} // namespace exam
