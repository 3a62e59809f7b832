// SPDX-License-Identifier: MIT
#include "warp_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "heat_map.h"
#include "html.h"
#include "page_style.h"
#include "point_picture.h"
#include "warp_plots.h"

namespace grader {

namespace {

constexpr std::size_t kShownMistakes = 5;

const char *styleOf(battery::Status status) {
    switch (status) {
    case battery::Status::Pass:
        return "pass";
    case battery::Status::Fail:
        return "fail";
    case battery::Status::Inconclusive:
        return "look";
    case battery::Status::NotRun:
        break;
    }
    return "none";
}

std::string mark(battery::Status status) {
    return fmt::format("<span class=\"verdict {}\">{}</span>", styleOf(status), label(status));
}

std::string table(std::initializer_list<const char *> heads, const std::string &rows) {
    std::string html = "<div class=\"scroll\"><table>\n<thead><tr>";
    for (const char *head : heads)
        html += fmt::format("<th scope=\"col\">{}</th>", head);
    return html + "</tr></thead>\n<tbody>\n" + rows + "</tbody>\n</table></div>\n";
}

std::string healthTable(const battery::TestResult &result) {
    std::string rows;
    for (const battery::TestRow &row : result.rows)
        rows += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                            escapeHtml(row.name), escapeHtml(row.value), escapeHtml(row.expected),
                            mark(row.status));
    return table({"Health", "Found", "Expected", "Verdict"}, rows);
}

std::string momentTable(const std::vector<battery::MomentRow> &moments) {
    if (moments.empty())
        return {};
    std::string rows;
    for (const battery::MomentRow &row : moments)
        rows +=
            fmt::format("<tr><th scope=\"row\">{}</th><td class=\"number\">{:.5f} ± {:.5f}</td>"
                        "<td class=\"number\">{:.5f}</td><td class=\"number\">{:+.1f}</td></tr>\n",
                        row.name, row.found, row.standardError, row.expected, row.z());
    return "<h3>Moments</h3>\n" + table({"Moment", "Found", "Expected", "z"}, rows);
}

std::string mistakeTable(const TestedWarp &test) {
    std::string rows;
    const std::size_t count = std::min(kShownMistakes, test.mistakes.size());
    for (std::size_t i = 0; i < count; ++i) {
        const battery::MistakeMatch &match = test.mistakes[i];
        rows += fmt::format("<tr><td>{}</td><td class=\"number\">{:.1f} %</td></tr>\n",
                            escapeHtml(match.mistake->description),
                            100.0 * std::max(0.0, match.explained));
    }
    // without a deviation there is nothing to explain
    if (test.result.verdict != battery::Status::Fail || rows.empty())
        return {};
    return "<h3>Nearest known mistakes of the warp</h3>\n" +
           table({"Mistake", "Explains of the deviation"}, rows);
}

/// A plot and, behind a button, all its numbers.
std::string figure(const plot::InlinePlot &plot, const std::string &id) {
    const plot::InlineDrawing drawing = plot::drawInline(plot, id);
    return fmt::format("<figure><figcaption><strong>{}</strong></figcaption>\n{}\n"
                       "<details><summary>Data, for gnuplot</summary><pre>{}</pre></details>"
                       "</figure>\n",
                       escapeHtml(plot.title), drawing.svg, escapeHtml(drawing.script));
}

std::string plots(const TestedWarp &test, const std::string &id) {
    std::string html = "<div class=\"plots\">\n";
    if (test.result.distribution.total > 0)
        html += figure(statisticPlot(test.result.distribution, test.significance), id + "s");
    html += figure(residualPlot(test.maps), id + "r");
    html += figure(slicePlot(test.maps, 0), id + "x") + figure(slicePlot(test.maps, 1), id + "y");
    if (test.result.seedPValues.size() > 1)
        html += figure(pValuePlot(test.result.seedPValues), id + "p");
    return html + "</div>\n";
}

std::string section(const TestedWarp &test, std::size_t index) {
    const battery::TestResult &result = test.result;
    const std::string id = fmt::format("w{}", index + 1);
    std::string html =
        fmt::format("<section aria-labelledby=\"{0}\">\n<h2 id=\"{0}\">{1}</h2>\n<p>{2} {3}</p>\n",
                    id, escapeHtml(test.title), mark(result.verdict), escapeHtml(result.headline));
    if (!result.error.empty())
        html += fmt::format("<p class=\"message\"><bdi>{}</bdi></p>\n", escapeHtml(result.error));
    if (!result.remarks.empty()) {
        html += "<ul>\n";
        for (const std::string &remark : result.remarks)
            html += fmt::format("<li>{}</li>\n", escapeHtml(remark));
        html += "</ul>\n";
    }
    if (!test.maps.observed.empty())
        html += mapFigures(test.maps);
    html += healthTable(result) + momentTable(test.moments);
    if (!result.power.empty())
        html += fmt::format("<p>{}</p>\n", escapeHtml(result.power));
    html += mistakeTable(test);
    if (!test.points.empty())
        html += pointPictures(*test.truth, test.inputs, test.points, test.pointSet);
    if (!test.maps.observed.empty())
        html += plots(test, id);
    return html + "</section>\n";
}

std::string overview(const WarpPage &page) {
    std::string rows;
    for (std::size_t i = 0; i < page.tests.size(); ++i) {
        const TestedWarp &test = page.tests[i];
        rows += fmt::format("<tr><th scope=\"row\"><a href=\"#w{}\">{}</a></th><td>{}</td>"
                            "<td>{}</td></tr>\n",
                            i + 1, escapeHtml(test.title), mark(test.result.verdict),
                            escapeHtml(test.result.headline));
    }
    return table({"Warp", "Verdict", "In words"}, rows);
}

/// JSON within a script element: no `<` may stand in it.
std::string embedded(const std::string &json) {
    std::string text;
    for (const char c : json)
        text += c == '<' ? std::string("\\u003c") : std::string(1, c);
    return text;
}

} // namespace

std::string warpPage(const WarpPage &page) {
    const auto passed = std::count_if(page.tests.begin(), page.tests.end(),
                                      [](const auto &test) { return test.result.passed(); });
    const std::string sum = fmt::format("{} of {} tests pass", passed, page.tests.size());
    std::string html =
        fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                    "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
                    "style-src '{}'; base-uri 'none'; form-action 'none'\">\n"
                    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                    "<title>Warps – {}</title>\n<style>{}</style>\n</head>\n<body>\n<main>\n"
                    "<h1>Sampling warps</h1>\n<p class=\"total\">{}</p>\n",
                    contentHash(kPageStyle), sum, kPageStyle, sum);
    html += overview(page);
    for (std::size_t i = 0; i < page.tests.size(); ++i)
        html += section(page.tests[i], i);
    html += fmt::format(
        "<section aria-labelledby=\"how\">\n<h2 id=\"how\">How this was tested</h2>\n<dl>\n"
        "<dt>Again</dt><dd><code>{}</code></dd>\n<dt>Program</dt><dd>warptest {}</dd>\n</dl>\n"
        "<p>A warp fails only if three tests on fresh random numbers reject alike, or where "
        "algebra "
        "decides. Maps are of points of their own. All numbers of this page stand in it as JSON, "
        "in "
        "the element <code>warptest</code>.</p>\n</section>\n",
        escapeHtml(page.command), escapeHtml(page.version));
    html += fmt::format("<script type=\"application/json\" id=\"warptest\">{}</script>\n",
                        embedded(page.json));
    return html + "</main>\n</body>\n</html>\n";
}

} // namespace grader
