// SPDX-License-Identifier: MIT
#pragma once

#include <viewer/view_model.h>

namespace viewer {

/// The left column: what to show and what to do.
class ControlsPanel {
public:
    void draw(ViewModel &model);

    /// The next frame puts the keyboard into the field of the parameter.
    void focusParameter() { m_focusParameter = true; }

private:
    void drawParameter(Settings &settings, const Subject &subject);

    bool m_focusParameter = false;
};

} // namespace viewer
