// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>

/// Progress with the time that is left, on the terminal's last line; nothing when stderr is no
/// terminal.
class ProgressBar {
public:
    /// \param enabled  false: never prints
    ProgressBar(std::string title, bool enabled);
    ~ProgressBar();
    ProgressBar(const ProgressBar &) = delete;
    ProgressBar &operator=(const ProgressBar &) = delete;

    /// \param fraction  in [0, 1]
    void update(double fraction);

private:
    std::string m_title;
    bool m_enabled;
    bool m_colored;
    std::chrono::steady_clock::time_point m_start;
    std::chrono::steady_clock::time_point m_shown;
};
