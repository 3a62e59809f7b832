// SPDX-License-Identifier: MIT
#include "progress.h"

#include <fmt/format.h>

#include <unistd.h>

#include <iostream>

namespace exam {

namespace {

constexpr double kMinutesFrom = 120; ///< seconds

} // namespace

Progress::Progress(std::size_t tasks)
    : m_tasks(tasks),
      m_start(std::chrono::steady_clock::now()),
      m_terminal(isatty(STDERR_FILENO) != 0) {}

void Progress::clear() const {
    if (m_terminal)
        std::cerr << "\r\x1b[K" << std::flush;
}

void Progress::add(bool isNew) {
    ++m_done;
    m_new += isNew ? 1 : 0;
    if (!m_terminal || m_new == 0 || m_done >= m_tasks)
        return;
    const double left =
        seconds() / static_cast<double>(m_new) * static_cast<double>(m_tasks - m_done);
    std::cerr << fmt::format("{} of {}, {:.0f} {} left", m_done, m_tasks,
                             left < kMinutesFrom ? left : left / 60,
                             left < kMinutesFrom ? "s" : "min")
              << std::flush;
}

double Progress::seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
}

} // namespace exam
