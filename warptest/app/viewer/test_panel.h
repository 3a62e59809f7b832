// SPDX-License-Identifier: MIT
#pragma once

#include <viewer/map_plot.h>
#include <viewer/view_model.h>

namespace viewer {

/// The right column: verdict, maps, health list, what it may mean.
class TestPanel {
public:
    void draw(ViewModel &model);

    void release() { m_maps.release(); }

private:
    /// \param errorIsShown  what it threw stands there already, as the points threw it too
    void drawReport(const std::shared_ptr<const TestReport> &report, bool stale, bool errorIsShown);

    MapPlot m_maps;
};

} // namespace viewer
