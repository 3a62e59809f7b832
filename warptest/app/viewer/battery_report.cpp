// SPDX-License-Identifier: MIT
#include <battery/battery.h>

#include <viewer/battery_report.h>

namespace viewer {

TestReport runBattery(const Subject &subject, const Settings &settings,
                      const TestControl &control) {
    const double a = settings.parameter;
    battery::TestOptions options;
    options.parameter = a;
    options.seed = settings.seed;
    options.repeats = settings.repeats;
    options.significance = settings.significance;
    options.samples = settings.samples;
    options.progress = control.progress;
    options.isCancelled = control.isCancelled;
    TestReport report;
    report.settings = settings;
    report.result = battery::testWarp(
        [&](std::span<const battery::Input> inputs) { return subject.warp(inputs, a); },
        [&](std::span<const battery::Output> points) { return subject.density(points, a); },
        *subject.truth, options);
    return report;
}

} // namespace viewer
