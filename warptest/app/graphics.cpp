// SPDX-License-Identifier: MIT
#include "graphics.h"

#include <fmt/core.h>

#include <stdexcept>
#include <utility>

#include <viewer/battery_report.h>
#include <viewer/evidence.h>
#include <viewer/warp_window.h>
#include <window/ui.h>

void showWarpWindow(const CommandLine &line, const std::vector<viewer::Subject> &subjects) {
    viewer::Actions actions;
    actions.test = viewer::runBattery;
    actions.save = [folder = line.evidence.empty() ? "figures" : line.evidence](
                       const viewer::Subject &subject, const viewer::TestReport &report) {
        return fmt::format("saved {}", saveEvidence(subject, report, folder));
    };
    viewer::WindowOptions options;
    options.scale = line.scale;
    options.theme = window::themeByName(line.theme);
    options.screenshot = line.screenshot;
    options.textFile = line.textFile;
    options.runAtStart = line.run;
    options.tab = line.tab - 1;
    try {
        viewer::showWindow(subjects, std::move(actions), line.settings, options);
    } catch (const window::NoWindow &error) {
        throw std::runtime_error(
            fmt::format("{}. `warptest WARP` tests without a window, `--screenshot FILE` draws one "
                        "without a display",
                        error.what()));
    }
}

std::string saveEvidence(const viewer::Subject &subject, const viewer::TestReport &report,
                         const std::string &folder) {
    return viewer::writeEvidence(subject, report, folder);
}
