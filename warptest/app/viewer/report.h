// SPDX-License-Identifier: MIT
#pragma once

#include <battery/battery.h>
#include <battery/maps.h>

#include <functional>
#include <string>

#include <viewer/settings.h>
#include <viewer/subject.h>

namespace viewer {

/// What the test panel shows of one test.
struct TestReport {
    Settings settings; ///< it was made with
    battery::TestResult result;
    double seconds = 0.0;
    battery::Maps maps; ///< of independent points; without cells after an error
};

/// A test that is done.
struct Tested {
    const Subject *subject = nullptr; ///< never null
    TestReport report;
};

/// "beckmann α = 0.1": what was tested.
std::string title(const Subject &subject, const TestReport &report);

/// How a test tells how far it is, and learns that it shall stop.
struct TestControl {
    std::function<void(double fraction)> progress;
    std::function<bool()> isCancelled;
};

/// What the window does with a warp, beside drawing it. Both run in a thread of their own.
struct Actions {
    /// Runs the whole battery. May throw: the window shows what().
    std::function<TestReport(const Subject &, const Settings &, const TestControl &)> test;
    /// Writes the evidence of a test. \return  what was written, for the status line
    std::function<std::string(const Subject &, const TestReport &)> save;
};

/// Independent points for the maps of a report: the battery's own samples are not kept.
inline constexpr std::size_t kMapPoints = std::size_t{1} << 18U;

/// Maps of fresh points. \throws what the warp throws
battery::Maps drawMaps(const Subject &subject, const Settings &settings);

} // namespace viewer
