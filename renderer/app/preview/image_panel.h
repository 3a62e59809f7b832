// SPDX-License-Identifier: MIT
#pragma once

#include <preview/view_model.h>
#include <window/texture.h>

namespace preview {

/// The image with what is drawn over it; dragging moves it, the wheel zooms.
class ImagePanel {
public:
    /// Fills what is left of ImGui's current window.
    void draw(ViewModel &model, float scale);

    void release() { m_texture.release(); }

    bool showsBlocks() const { return m_blocks; }

    void showBlocks(bool show) { m_blocks = show; }

private:
    void handleMouse(ViewModel &model, const ImVec2 &corner);
    void drawOverlays(const ViewModel &model, const ImVec2 &corner, float scale) const;
    void drawValues(const ViewModel &model, const ImVec2 &corner, const ImVec2 &size,
                    float scale) const;

    window::Texture m_texture;
    unsigned m_revision = 0;
    bool m_blocks = true;
};

} // namespace preview
