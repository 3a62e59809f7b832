// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

/// Plots, drawn by gnuplot. Data and script stay beside the pictures, so that anyone can redraw
/// them.
namespace plot {

/// gnuplot is missing or refused; the message says which and what to do.
class PlotError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

struct Point {
    double x = 0.0;
    double y = 0.0;
    double low = 0.0; ///< confidence interval of y; shown as a band and as a bar
    double high = 0.0;
};

struct Series {
    std::string label;
    std::vector<Point> points;
};

/// Both axes logarithmic: everything in it must be > 0.
struct LogLogPlot {
    std::string title;
    std::string xLabel;
    std::string yLabel;
    std::vector<Series> series; ///< told apart by colour, dash and mark: also in black and white
    double guideSlope = 0.0;    ///< of a thin line through the first point, for comparison; 0: none
};

/// Writes STEM.dat, STEM.gp, STEM.svg, STEM.pdf and STEM.png. The SVG takes its text's and axes'
/// colour from the page around it, or, alone, from the reader's light or dark setting.
/// \throws PlotError  if gnuplot cannot be run, or a file cannot be written
void writePlot(const LogLogPlot &plot, const std::filesystem::path &stem);

} // namespace plot
