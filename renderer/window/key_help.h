// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace window {

/// A line of the dialog "Keys".
struct KeyHelp {
    const char *keys; ///< "E, Shift+E"; empty: a sentence over both columns
    const char *what;
};

/// The dialog "Keys". Call it in every frame. \param open  true in the frame in which it opens;
/// becomes false
void drawKeyHelp(bool &open, const std::vector<KeyHelp> &lines);

} // namespace window
