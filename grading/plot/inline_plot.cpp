// SPDX-License-Identifier: MIT
#include "inline_plot.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>

#include "gnuplot.h"

namespace plot {

namespace {

/// What stands after `using`. Okabe and Ito's colours, which the colour-blind tell apart; black
/// becomes the colour of the page's text.
std::string drawnAs(Form form) {
    switch (form) {
    case Form::Line:
        return "1:2 with lines linewidth 1.5 linecolor rgb '#0072B2'";
    case Form::Dashes:
        return "1:2 with lines dashtype 2 linewidth 1.5 linecolor rgb '#D55E00'";
    case Form::Bars: // a colour after `border` would be the border's
        return "1:2 with boxes linecolor rgb '#56B4E9' fillstyle transparent solid 0.4 border";
    case Form::Area:
        return "1:2 with filledcurves y1=0 linecolor rgb '#E69F00' fillstyle solid noborder";
    case Form::Band:
        return "1:3:4 with filledcurves linecolor rgb '#009E73' fillstyle transparent solid 0.25 "
               "noborder";
    case Form::Marks:
        return "1:2 with points pointtype 7 pointsize 0.5 linecolor rgb 'black'";
    case Form::Errors:
        return "1:2:3:4 with yerrorbars pointtype 7 pointsize 0.4 linecolor rgb 'black'";
    case Form::Spike:
        break;
    }
    return "1:2 with impulses linewidth 2.5 linecolor rgb '#D55E00'";
}

std::string scriptOf(const InlinePlot &plot) {
    std::string text = "set encoding utf8\nset pointintervalbox 0\nset border 3\nset tics "
                       "nomirror\nset key outside bottom "
                       "center horizontal height 1\n";
    text += fmt::format("set xlabel {}\nset ylabel {}\nset yrange [0:*]\n", quoted(plot.xLabel),
                        quoted(plot.yLabel));
    std::string parts;
    for (std::size_t i = 0; i < plot.layers.size(); ++i) {
        const Layer &layer = plot.layers[i];
        text += fmt::format("$data{} << EOD\n", i);
        for (const Point &point : layer.points)
            text += fmt::format("{:.6g} {:.6g} {:.6g} {:.6g}\n", point.x, point.y, point.low,
                                point.high);
        text += "EOD\n";
        parts += fmt::format("{}  $data{} using {} title {}", parts.empty() ? "" : ", \\\n", i,
                             drawnAs(layer.form), quoted(layer.label));
    }
    return text + "plot \\\n" + parts + "\n";
}

void replaceAll(std::string &text, const std::string &from, const std::string &to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
}

/// Drops everything from each `from` up to and including the next `to`.
void removeSpans(std::string &text, const std::string &from, const std::string &to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos;) {
        const std::size_t end = text.find(to, at);
        if (end == std::string::npos)
            return;
        text.erase(at, end + to.size() - at);
    }
}

/// The element alone, with ids of its own and a title that says what it shows.
std::string asElement(std::string svg, const InlinePlot &plot, const std::string &id) {
    svg.erase(0, svg.find("<svg"));
    removeSpans(svg, "<title>", "</title>"); // gnuplot's names of its own parts
    removeSpans(svg, "<desc>", "</desc>");
    for (const char quote : {'\'', '"'}) {
        replaceAll(svg, fmt::format("id={}", quote), fmt::format("id={}{}-", quote, id));
        replaceAll(svg, fmt::format("href={}#", quote), fmt::format("href={}#{}-", quote, id));
    }
    std::string title;
    for (const char c : plot.title)
        title += c == '<' ? "&lt;" : c == '&' ? "&amp;" : c == '"' ? "&quot;" : std::string(1, c);
    svg.insert(4, fmt::format(R"( class="plot" role="img" aria-label="{}")", title));
    return withTextColour(std::move(svg));
}

/// A folder for one run, that goes with it.
class Scratch {
public:
    Scratch() {
        std::string name =
            (std::filesystem::temp_directory_path() / "norigrade-plot-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            throw PlotError("no folder for a plot can be made in " +
                            std::filesystem::temp_directory_path().string());
        m_path = name;
    }

    ~Scratch() {
        std::error_code ignored;
        std::filesystem::remove_all(m_path, ignored);
    }

    Scratch(const Scratch &) = delete;
    Scratch(Scratch &&) = delete;
    Scratch &operator=(const Scratch &) = delete;
    Scratch &operator=(Scratch &&) = delete;

    [[nodiscard]] const std::filesystem::path &path() const { return m_path; }

private:
    std::filesystem::path m_path;
};

} // namespace

InlineDrawing drawInline(const InlinePlot &plot, const std::string &id) {
    const Scratch scratch;
    const std::string script = scriptOf(plot);
    writeFile(scratch.path() / "plot.gp", script);
    runGnuplot(scratch.path(),
               "set terminal svg noenhanced size 460,300 dynamic font 'sans-serif,13'; set output "
               "'plot.svg'",
               "plot.gp");
    return {asElement(readFile(scratch.path() / "plot.svg"), plot, id), script};
}

} // namespace plot
