// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

#include <preview/view_model.h>

namespace preview {

// What needs the packages of NORI_GUI; without them no window can be shown.

struct WindowOptions {
    double scale = 0;           ///< of text and spaces; 0: as the display says
    std::string theme = "dark"; ///< dark, light or contrast
    std::string screenshot;     ///< if not empty: draws into this PNG file, without a display
    std::string textFile;       ///< with a screenshot: the window's texts as well
};

/// There can be no window: what() says why and what to do instead, without the last full stop.
class CannotShow : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Whether windows were built and a display is named in the environment.
bool canShow();

/// Shows the window until it is closed, or draws it into a file when nothing moves any more. The
/// model's job is started when the window is there.
/// \throws CannotShow  std::runtime_error if a file cannot be written
void show(ViewModel &model, const WindowOptions &options);

} // namespace preview
