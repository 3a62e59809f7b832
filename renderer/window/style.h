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

/// Adds the windows' font to an atlas: DejaVu Sans, or ImGui's own, which holds no accents, if that
/// is not installed.
/// \param oversampling  columns of the atlas for one pixel
ImFont *addFont(ImFontAtlas &fonts, float scale, int oversampling);

/// Sets the colours and sizes of ImGui's current context and fills its font atlas.
void setStyle(Theme theme, float scale);

} // namespace window
