// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <plot/plot.h>

namespace plot {

/// How a layer of an inline plot is drawn. Told apart by form, not by colour alone.
enum class Form {
    Line,
    Dashes,
    Bars,   ///< boxes from 0
    Area,   ///< filled from 0
    Band,   ///< between low and high
    Marks,  ///< points
    Errors, ///< points with bars from low to high
    Spike,  ///< vertical line from 0, for a single value
};

struct Layer {
    std::string label;
    Form form = Form::Line;
    std::vector<Point> points;
};

/// Linear axes, for a page. Layers are drawn in their order.
struct InlinePlot {
    std::string title; ///< for readers who do not see it
    std::string xLabel;
    std::string yLabel;
    std::vector<Layer> layers;
};

struct InlineDrawing {
    std::string svg;    ///< an element for a page: takes the colour of the text around it
    std::string script; ///< of gnuplot, with all data: draws it again anywhere
};

/// \param id  a prefix that makes its ids unique in the page: letters, digits
/// \throws PlotError  if gnuplot cannot be run
InlineDrawing drawInline(const InlinePlot &plot, const std::string &id);

} // namespace plot
