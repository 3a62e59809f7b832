// SPDX-License-Identifier: MIT
#include "progress_bar.h"

#include <fmt/core.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace {

constexpr auto kInterval = std::chrono::milliseconds(100);
constexpr int kDefaultWidth = 80;

int terminalWidth() {
    winsize size{};
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col
                                                                           : kDefaultWidth;
}

std::string duration(double seconds) {
    const auto s = static_cast<int>(std::lround(seconds));
    if (s >= 3600)
        return fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
    return fmt::format("{}:{:02}", s / 60, s % 60);
}

} // namespace

ProgressBar::ProgressBar(std::string title, bool enabled)
    : m_title(std::move(title)),
      m_enabled(enabled && isatty(STDERR_FILENO) == 1),
      m_colored(std::getenv("NO_COLOR") == nullptr),
      m_start(std::chrono::steady_clock::now()) {}

ProgressBar::~ProgressBar() {
    if (m_enabled)
        fmt::print(stderr, "\r\x1b[K");
}

void ProgressBar::update(double fraction) {
    const auto now = std::chrono::steady_clock::now();
    if (!m_enabled || now - m_shown < kInterval)
        return;
    m_shown = now;
    const double elapsed = std::chrono::duration<double>(now - m_start).count();
    const std::string left =
        fraction > 0 ? duration(elapsed / fraction * (1 - fraction)) + " left" : "";
    const std::string tail = fmt::format(" {:3.0f} % {}", 100 * fraction, left);
    const int room =
        terminalWidth() - static_cast<int>(m_title.size()) - static_cast<int>(tail.size()) - 5;
    const int width = std::clamp(room, 0, 40);
    const int full = static_cast<int>(fraction * width);
    const char *color = m_colored ? "\x1b[32m" : "";
    const char *plain = m_colored ? "\x1b[0m" : "";
    fmt::print(stderr, "\r{} [{}{}{}{}]{}\x1b[K", m_title, color, std::string(full, '#'), plain,
               std::string(width - full, '.'), tail);
    std::fflush(stderr);
}
