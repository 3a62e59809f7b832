// SPDX-License-Identifier: MIT
#pragma once

#include <nori/common.h>

#include <chrono>

NORI_NAMESPACE_BEGIN

/// Stop watch in milliseconds of real time.
class Timer {
public:
    Timer() : m_start(Clock::now()) {}

    void reset() { m_start = Clock::now(); }

    double elapsed() const {
        return std::chrono::duration<double, std::milli>(Clock::now() - m_start).count();
    }

    std::string elapsedString(bool precise = false) const { return timeString(elapsed(), precise); }

    /// As elapsed(), and starts again.
    double lap() {
        const Clock::time_point now = Clock::now();
        const double result = std::chrono::duration<double, std::milli>(now - m_start).count();
        m_start = now;
        return result;
    }

    std::string lapString(bool precise = false) { return timeString(lap(), precise); }

private:
    typedef std::chrono::steady_clock Clock;

    Clock::time_point m_start;
};

NORI_NAMESPACE_END
