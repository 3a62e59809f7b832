// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <viewer/view_model.h>
#include <window/ui.h>

namespace viewer {

struct WindowOptions {
    double scale = 0.0; ///< of text and spaces; 0: as the display says
    window::Theme theme = window::Theme::Dark;
    std::string screenshot;  ///< if not empty: draws into this PNG file, without a display
    std::string textFile;    ///< with a screenshot: the window's texts as well
    bool runAtStart = false; ///< presses "Run the test" first
    int tab = 0;             ///< of the points: 0 space, 1 unit square, 2 domain map
};

/// Shows the window until it is closed, or draws it into a file.
/// \param actions  their functions are called from another thread
/// \throws window::NoWindow  if neither is possible: one sentence that helps
void showWindow(std::vector<Subject> subjects, Actions actions, const Settings &settings,
                const WindowOptions &options);

} // namespace viewer
