// SPDX-License-Identifier: MIT
#include <catalog/warp_catalog.h>
#include <grader/report/heat_map.h>

#include <gtest/gtest.h>

#include <vector>

namespace grader {
namespace {

/// Of the square, in 4x4 cells with 10 points expected in each.
battery::Maps mapsOf(std::vector<double> counts, std::size_t points = 160) {
    return battery::mapsOfCounts(catalog::requireWarp("square"), 0.0, std::move(counts), points);
}

std::size_t count(const std::string &text, const std::string &part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

TEST(PlaceOf, IsTheCentreOfACell) {
    EXPECT_EQ(placeOf(mapsOf(std::vector<double>(16, 10.0)), 6), "x 0.625, y 0.375");
}

TEST(MapFigures, SayInWordsWhatTheyShow) {
    std::vector<double> counts(16, 10.0);
    counts[6] = 30.0;
    const std::string html = mapFigures(mapsOf(counts, 200));
    for (const char *part :
         {"Map of the observed counts", "Map of the expected counts", "Map of the residuals",
          // 12.5 are expected: (30 - 12.5) / sqrt(12.5)
          "largest residual is +4.9 σ at x 0.625, y 0.375: 30 observed, 12.5 expected",
          "200 independent points in 4×4 cells, 20 outside of the map", "30 points in a cell"})
        EXPECT_NE(html.find(part), std::string::npos) << part << html;
    EXPECT_EQ(count(html, "<figure"), 3U);
    EXPECT_EQ(html.find(" id="), std::string::npos) << "a page may hold several";
}

TEST(MapFigures, DrawEachCellOnceWithRowZeroAtTheBottom) {
    std::vector<double> counts(16, 10.0);
    counts[0] = 40.0;
    const std::string html = mapFigures(mapsOf(counts, 190));
    EXPECT_EQ(count(html, "h1v1h-1z"), 48U);
    const std::size_t observed = html.find("Map of the observed");
    // the one cell of its colour: column 0, the lowest of four rows
    EXPECT_NE(html.find("d=\"M0 3h1v1h-1z\"", observed), std::string::npos);
    EXPECT_EQ(html.find("d=\"M0 0h1v1h-1z\""), std::string::npos);
}

TEST(MapFigures, ListTheFiveCellsThatAreFarthestOff) {
    std::vector<double> counts(16, 10.0);
    for (std::size_t i = 0; i < 6; ++i)
        counts[i] = 20.0 - static_cast<double>(i);
    const std::string html = mapFigures(mapsOf(counts));
    EXPECT_EQ(count(html, "<th scope=\"row\">"), 5U);
    EXPECT_NE(html.find("x 0.125, y 0.125</th><td class=\"number\">20</td><td "
                        "class=\"number\">10.0</td><td class=\"number\">+3.2</td>"),
              std::string::npos)
        << html;
    EXPECT_EQ(html.find("<td class=\"number\">15</td>"), std::string::npos);
}

TEST(MapFigures, ShowCellsWithoutAResidualInGrey) {
    EXPECT_EQ(count(mapFigures(mapsOf(std::vector<double>(16, 10.0))), "#808080"), 0U);
    const std::string few = mapFigures(mapsOf(std::vector<double>(16, 1.0), 16));
    EXPECT_EQ(count(few, "fill=\"#808080\""), 1U);
}

} // namespace
} // namespace grader
