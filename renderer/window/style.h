// SPDX-License-Identifier: MIT
#pragma once

#include <imgui/imgui.h>
#include <window/ui.h>

namespace window {

/// Colours with a meaning. Every status is told by a sign and a word as well.
struct Palette {
    ImVec4 pass;
    ImVec4 fail;
    ImVec4 check; ///< cannot tell, or look at this
    ImVec4 muted; ///< not run, remarks
    ImVec4 accent;
    ImVec4 ink;   ///< lines over the background of a plot
    ImVec4 paper; ///< the background of a plot
};

/// Of the theme that was set last.
const Palette &palette();

/// Sets the colours and sizes of ImGui's current context and fills its font atlas: DejaVu Sans,
/// or ImGui's own font, which holds no accents, if it is not installed.
void setStyle(Theme theme, float scale);

} // namespace window
