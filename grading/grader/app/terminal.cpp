// SPDX-License-Identifier: MIT
#include "terminal.h"

#include <grader/report/text_layout.h>
#include <grader/results/safe_text.h>

#include <fmt/format.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace grader {

namespace {

constexpr std::size_t kUsualWidth = 80;
constexpr std::size_t kNarrowest = 20;
constexpr auto kRedrawTime = std::chrono::milliseconds(100);

std::string environment(const char *name) {
    const char *value = std::getenv(name);
    return value != nullptr ? value : "";
}

std::size_t terminalWidth(int descriptor) {
    const std::string columns = environment("COLUMNS");
    std::size_t width = 0;
    std::from_chars(columns.data(), columns.data() + columns.size(), width);
    if (width >= kNarrowest)
        return width;
    if (::isatty(descriptor) == 0)
        return 0;

    winsize size{};

    if (::ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col >= kNarrowest)
        return size.ws_col;
    return kUsualWidth;
}

bool isUtf8Locale() {
    for (const char *name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
        std::string value = environment(name);
        if (value.empty())
            continue;
        std::transform(value.begin(), value.end(), value.begin(),
                       [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
        return value.find("utf-8") != std::string::npos || value.find("utf8") != std::string::npos;
    }
    return false;
}

} // namespace

TerminalStyle terminalStyle(int descriptor) {
    TerminalStyle style;
    style.width = terminalWidth(descriptor);
    style.colour = ::isatty(descriptor) != 0 && environment("NO_COLOR").empty() &&
                   environment("TERM") != "dumb";
    style.unicodeSigns = isUtf8Locale();
    return style;
}

void complain(const std::string &message) {
    fmt::print(stderr, "norigrade: {}\n", safeLines(message));
}

ProgressLine::ProgressLine(bool shown)
    : m_shown(shown && ::isatty(STDERR_FILENO) != 0 && environment("TERM") != "dumb"),
      m_width(terminalWidth(STDERR_FILENO)) {}

void ProgressLine::update(std::string_view what, std::string_view phase, double fraction) {
    if (!m_shown)
        return;
    const std::lock_guard<std::mutex> lock(m_mutex);
    const auto now = std::chrono::steady_clock::now();
    if (m_isDrawn && now - m_last < kRedrawTime)
        return;
    const long percent = std::lround(100 * std::clamp(fraction, 0.0, 1.0));
    const std::string text = safeLine(fmt::format("{}: {} {} %", what, phase, percent));
    fmt::print(stderr, "\r{}\x1b[K", wrapText(text, m_width > 0 ? m_width - 1 : 0).front());
    std::fflush(stderr);
    m_isDrawn = true;
    m_last = now;
}

void ProgressLine::clear() {
    const std::lock_guard<std::mutex> lock(m_mutex);
    if (m_isDrawn) {
        fmt::print(stderr, "\r\x1b[K");
        std::fflush(stderr);
    }
    m_isDrawn = false;
}

} // namespace grader
