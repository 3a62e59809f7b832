// SPDX-License-Identifier: MIT
#pragma once

#include <grader/report/terminal_report.h>

#include <chrono>
#include <mutex>
#include <string>
#include <string_view>

namespace grader {

/// What stands behind a descriptor: width from COLUMNS or the terminal, colour only on a terminal
/// that is not `dumb` and without NO_COLOR, signs where the locale is UTF-8.
TerminalStyle terminalStyle(int descriptor);

/// `norigrade: message` on standard error; control characters in it go.
void complain(const std::string &message);

/// One line on standard error that says what is going on; nothing where that is no terminal.
/// Thread-safe.
class ProgressLine {
public:
    /// \param shown  false: writes nothing
    explicit ProgressLine(bool shown);

    ~ProgressLine() { clear(); }

    ProgressLine(const ProgressLine &) = delete;
    ProgressLine(ProgressLine &&) = delete;
    ProgressLine &operator=(const ProgressLine &) = delete;
    ProgressLine &operator=(ProgressLine &&) = delete;

    /// Replaces the line; at most ten times in a second.
    /// \param fraction  done of this phase [0, 1]
    void update(std::string_view what, std::string_view phase, double fraction);

    /// Takes the line away, before other output.
    void clear();

private:
    bool m_shown;
    std::size_t m_width;
    bool m_isDrawn = false;
    std::chrono::steady_clock::time_point m_last;
    std::mutex m_mutex;
};

} // namespace grader
