// SPDX-License-Identifier: MIT
#pragma once

#include <preview/view_model.h>

namespace preview {

/// Numbers: the pixel under the cursor, the whole image, the reference, the error over time. Fills
/// ImGui's current window.
void drawSidePanel(ViewModel &model, float scale);

} // namespace preview
