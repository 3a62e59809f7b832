// SPDX-License-Identifier: MIT
#include "plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "gnuplot.h"

namespace plot {

namespace {

/// Okabe and Ito's colours, which also the colour-blind tell apart, without those that are too pale
/// for a white page or too dark for a black one.
constexpr const char *kColors[] = {"#0072B2", "#D55E00", "#009E73",
                                   "#CC79A7", "#E69F00", "#56B4E9"};
constexpr int kMarks[] = {7, 5, 9, 13, 6, 4};
constexpr const char *kDashes[] = {"1", "2", "4", "5", "3", "6"};

struct Terminal {
    const char *suffix;
    const char *options;
};

constexpr Terminal kTerminals[] = {
    {".svg", "svg noenhanced size 720,480 dynamic font 'sans-serif,14'"},
    {".pdf", "pdfcairo noenhanced size 6in,4in font 'sans,11'"},
    {".png", "pngcairo noenhanced size 1440,960 font 'sans,22' linewidth 2"}};

std::string dataOf(const LogLogPlot &plot) {
    std::string text = "# x y low high; a block per series, in the order of the script\n";
    for (const Series &series : plot.series) {
        for (const Point &point : series.points)
            text += fmt::format("{:.9g} {:.9g} {:.9g} {:.9g}\n", point.x, point.y, point.low,
                                point.high);
        text += "\n\n";
    }
    return text;
}

std::string scriptOf(const LogLogPlot &plot, const std::string &data) {
    std::string text = "# gnuplot -e \"set terminal pngcairo; set output 'plot.png'\" THIS\n";
    text += "set encoding utf8\nset logscale xy\nset grid back linewidth 0.5 linecolor rgb "
            "'#909090'\nset key outside "
            "bottom center horizontal height 1\nset border 3\nset tics nomirror\nset format x "
            "'%g'\nset format y '%g'\n";
    // Every number of samples that was measured is labelled, and nothing else.
    std::set<double> measured;
    for (const Series &series : plot.series) {
        for (const Point &point : series.points)
            measured.insert(point.x);
    }
    const double least = measured.empty() ? 0.0 : *measured.begin();
    const double most = measured.empty() ? 0.0 : *measured.rbegin();
    text += fmt::format("set xtics ({:.9g})\n", fmt::join(measured, ", "));
    constexpr double kMargin = 1.25; // so that no mark stands on an axis
    text += fmt::format("set xrange [{:.9g}:{:.9g}]\n", least / kMargin, most * kMargin);
    text += fmt::format("set title {}\nset xlabel {}\nset ylabel {}\n", quoted(plot.title),
                        quoted(plot.xLabel), quoted(plot.yLabel));
    std::string parts;
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
        const char *const color = kColors[i % std::size(kColors)];
        parts += fmt::format("  {0} index {1} using 1:3:4 with filledcurves fillcolor rgb '{2}' "
                             "fillstyle transparent solid 0.2 noborder notitle, \\\n"
                             "  {0} index {1} using 1:2:3:4 with yerrorlines linecolor rgb '{2}' "
                             "dashtype {3} pointtype {4} linewidth 1.5 title {5}",
                             quoted(data), i, color, kDashes[i % std::size(kDashes)],
                             kMarks[i % std::size(kMarks)], quoted(plot.series[i].label));
        parts += i + 1 < plot.series.size() ? ", \\\n" : "";
    }
    if (plot.guideSlope != 0.0 && !plot.series.empty() && !plot.series.front().points.empty()) {
        const Point &start = plot.series.front().points.front();
        parts += fmt::format(", \\\n  {:.9g} * (x / {:.9g}) ** {:g} with lines linecolor rgb "
                             "'#808080' linewidth 1 dashtype 3 title 'slope {:g}'",
                             start.y, start.x, plot.guideSlope, plot.guideSlope);
    }
    return text + "plot \\\n" + parts + '\n';
}

/// Also alone in light and dark.
std::string adaptive(std::string svg) {
    svg = withTextColour(std::move(svg));
    // Only an image that stands alone: inside a page `:root` would be the page.
    const std::size_t end = svg.find('>', svg.find("<svg"));
    if (end != std::string::npos)
        svg.insert(end + 1, "\n<style>svg:root { color: #222 } @media (prefers-color-scheme: dark) "
                            "{ svg:root { color: #ddd } }</style>");
    return svg;
}

} // namespace

void writePlot(const LogLogPlot &plot, const std::filesystem::path &stem) {
    const std::string name = stem.filename().string();
    const std::filesystem::path folder = stem.has_parent_path() ? stem.parent_path() : ".";
    writeFile(folder / (name + ".dat"), dataOf(plot));
    writeFile(folder / (name + ".gp"), scriptOf(plot, name + ".dat"));
    for (const Terminal &terminal : kTerminals) {
        const std::string output = name + terminal.suffix;
        runGnuplot(folder,
                   fmt::format("set terminal {}; set output {}", terminal.options, quoted(output)),
                   name + ".gp");
    }
    const std::filesystem::path svg = folder / (name + ".svg");
    writeFile(svg, adaptive(readFile(svg)));
}

} // namespace plot
