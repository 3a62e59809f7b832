// SPDX-License-Identifier: MIT
#pragma once

#include <battery/domain_map.h>

#include <array>
#include <optional>

#include <viewer/arcball.h>
#include <viewer/view_model.h>
#include <window/point_view.h>
#include <window/ui.h>

namespace viewer {

/// The middle column: the points in space, in the unit square and in the map of the domain.
class SamplesPanel {
public:
    void draw(ViewModel &model, const window::Frame &frame);
    void release();

    /// Shows this tab from the next frame on: 0, 1 or 2.
    void showTab(int tab) { m_wantedTab = tab; }

private:
    /// A flat view in which one brushes.
    struct FlatView {
        window::PointView points;
        std::optional<std::array<double, 2>> brushStart;
        unsigned revision = 0;
    };

    void drawSpace(ViewModel &model, const window::Frame &frame);
    void drawFlat(ViewModel &model, const window::Frame &frame, Brush::View which);
    void drawTurnButtons(bool directions);
    void handleSpaceMouse(float width, float height);
    void uploadSpace(ViewModel &model);
    void uploadFlat(ViewModel &model, Brush::View which, const battery::DomainMap &domain);

    int m_wantedTab = -1;
    Arcball m_ball;
    window::PointView m_space;
    std::array<FlatView, 2> m_flat; ///< by Brush::View
    std::optional<unsigned> m_spaceRevision;
    window::Theme m_theme = window::Theme::Dark; ///< that the vertices were coloured for
    std::optional<std::size_t> m_warp;           ///< that the ball was set for
};

} // namespace viewer
