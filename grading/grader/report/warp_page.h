// SPDX-License-Identifier: MIT
#pragma once

#include <battery/battery.h>
#include <battery/maps.h>
#include <battery/moment_rows.h>

#include <string>
#include <vector>

namespace grader {

/// One tested warp, with what a page shows of it.
struct TestedWarp {
    const catalog::WarpEntry *truth = nullptr; ///< never null
    std::string title;                         ///< "triangle of mine.cpp"
    battery::TestResult result;
    double significance = 1e-4;
    battery::Maps maps;                          ///< without cells: not shown
    std::vector<battery::MistakeMatch> mistakes; ///< best first
    std::vector<battery::MomentRow> moments;     ///< of the maps' points; empty: not shown
    std::vector<battery::Input> inputs;          ///< of the points that are shown
    std::vector<battery::Output> points;         ///< shape as `inputs`, or empty
    std::string pointSet;                        ///< "stratified"
};

struct WarpPage {
    std::vector<TestedWarp> tests;
    std::string command; ///< that makes it again
    std::string version; ///< of the program
    std::string json;    ///< all data; stands in the page as it is
};

/// A page of its own: readable without a server, a network or scripts, in light, dark and print.
/// \throws plot::PlotError  if gnuplot cannot be run
std::string warpPage(const WarpPage &page);

} // namespace grader
