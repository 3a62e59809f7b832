// SPDX-License-Identifier: MIT
#pragma once

#include <battery/maps.h>

#include <array>
#include <memory>
#include <string>

#include <window/texture.h>

namespace viewer {

/// Three maps with their colour bars, and the numbers of one cell in words.
class MapPlot {
public:
    /// \param side  of one map [pixels]
    void draw(const std::shared_ptr<const battery::Maps> &maps, float side);
    void release();

private:
    void upload();
    void drawMap(std::size_t which, float side);
    void drawCellText() const;

    std::shared_ptr<const battery::Maps> m_maps;
    std::array<window::Texture, 3> m_textures;
    std::array<int, 2> m_cell{0, 0}; ///< column, row: the worst, under the pointer, or typed
};

/// A vertical bar with its legend at the cursor of ImGui.
/// \param isSigned  diverging from -high to high, else viridis from 0 to high
void drawColorBar(bool isSigned, double high, float height);

} // namespace viewer
