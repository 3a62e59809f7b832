// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include <plot/inline_plot.h>

namespace plot {
namespace {

InlinePlot everyForm() {
    InlinePlot plot{"5 < \"σ\" & more", "x {0}", "y_'1'", {}};
    for (const Form form : {Form::Line, Form::Dashes, Form::Bars, Form::Area, Form::Band,
                            Form::Marks, Form::Errors, Form::Spike})
        plot.layers.push_back({"layer " + std::to_string(static_cast<int>(form)),
                               form,
                               {{0.125, 1.0, 0.5, 1.5}, {2.0, 3.0, 2.5, 3.5}}});
    return plot;
}

TEST(DrawInline, GivesAnElementInTheColourOfThePage) {
    const std::string svg = drawInline(everyForm(), "a").svg;
    EXPECT_EQ(svg.compare(0, 4, "<svg"), 0);
    for (const char *part : {"class=\"plot\"", "aria-label=\"5 &lt; &quot;σ&quot; &amp; more\"",
                             "currentColor", "x {0}", "layer 7"})
        EXPECT_NE(svg.find(part), std::string::npos) << part;
    for (const char *part : {"<?xml", "<title>", "<script", "\"black\"", "#000000"})
        EXPECT_EQ(svg.find(part), std::string::npos) << part;
}

TEST(DrawInline, HasIdsOfItsOwn) {
    const std::string svg = drawInline(everyForm(), "w3").svg;
    std::size_t ids = 0;
    for (const std::string &mark : {std::string(" id="), std::string("href=")}) {
        for (std::size_t at = svg.find(mark); at != std::string::npos;
             at = svg.find(mark, at + 1)) {
            const std::size_t name = at + mark.size() + 1 + (mark == "href=" ? 1 : 0);
            EXPECT_EQ(svg.compare(name, 3, "w3-"), 0) << svg.substr(at, 40);
            ++ids;
        }
    }
    EXPECT_GT(ids, 0U);
}

TEST(DrawInline, GivesTheScriptWithAllData) {
    const std::string script = drawInline(everyForm(), "a").script;
    for (const char *part : {"0.125 1 0.5 1.5\n2 3 2.5 3.5\nEOD", "$data7", "'y_''1'''"})
        EXPECT_NE(script.find(part), std::string::npos) << part << "\n" << script;
}

TEST(DrawInline, IsTheSameEveryTime) {
    EXPECT_EQ(drawInline(everyForm(), "a").svg, drawInline(everyForm(), "a").svg);
}

TEST(DrawInline, SaysThatGnuplotIsMissing) {
    const std::string path = std::getenv("PATH");
    ::setenv("PATH", "/nowhere", 1);
    EXPECT_THROW(drawInline(everyForm(), "a"), PlotError);
    ::setenv("PATH", path.c_str(), 1);
    EXPECT_THROW(drawInline({"nothing", "x", "y", {}}, "a"), PlotError);
}

} // namespace
} // namespace plot
