// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include <plot/plot.h>

namespace plot {
namespace {

class WritePlot : public testing::Test {
protected:
    void SetUp() override {
        m_folder = std::filesystem::temp_directory_path() /
                   ("norigrade_plot_test '" + std::to_string(::getpid()));
        std::filesystem::create_directories(m_folder);
    }

    void TearDown() override { std::filesystem::remove_all(m_folder); }

    std::string read(const std::string &name) const {
        std::ifstream stream(m_folder / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    }

    LogLogPlot m_plot{"title of 'this'\nset output",
                      "samples",
                      "error",
                      {{"señal_a {x}", {{1, 1, 0.9, 1.1}, {4, 0.5, 0.45, 0.55}}},
                       {"b", {{1, 2, 1.9, 2.1}, {4, 1, 0.9, 1.1}}}},
                      -0.5};
    std::filesystem::path m_folder;
};

TEST_F(WritePlot, LeavesPicturesScriptAndData) {
    writePlot(m_plot, m_folder / "a plot");
    EXPECT_EQ(read("a plot.pdf").substr(0, 5), "%PDF-");
    EXPECT_EQ(read("a plot.png").substr(1, 3), "PNG");
    const std::string svg = read("a plot.svg");
    for (const char *part : {"señal_a {x}", "title of", "currentColor", "prefers-color-scheme"})
        EXPECT_NE(svg.find(part), std::string::npos) << part;
    for (const char *black : {"\"black\"", "'black'", "rgb(  0,   0,   0)", "#000000"})
        EXPECT_EQ(svg.find(black), std::string::npos) << "invisible on a dark page: " << black;
    EXPECT_NE(read("a plot.dat").find("4 0.5 0.45 0.55"), std::string::npos);
    EXPECT_NE(read("a plot.gp").find("'title of ''this'' set output'"), std::string::npos);
}

TEST_F(WritePlot, LabelsTheMeasuredNumbersOfSamples) {
    m_plot.series[0].points.push_back({16, 0.25, 0.2, 0.3});
    writePlot(m_plot, m_folder / "plot");
    EXPECT_NE(read("plot.gp").find("set xtics (1, 4, 16)"), std::string::npos);
    for (const char *label : {">1<", ">4<", ">16<"})
        EXPECT_NE(read("plot.svg").find(label), std::string::npos) << label;
}

TEST_F(WritePlot, ColoursNothingOfThePageAroundIt) {
    writePlot(m_plot, m_folder / "plot");
    const std::string svg = read("plot.svg");
    EXPECT_NE(svg.find("svg:root { color"), std::string::npos);
    EXPECT_EQ(svg.find(" :root"), std::string::npos);
    EXPECT_EQ(svg.find(">:root"), std::string::npos);
}

TEST_F(WritePlot, SaysThatGnuplotIsMissing) {
    const std::string path = std::getenv("PATH");
    ::setenv("PATH", m_folder.c_str(), 1);
    std::string message;
    try {
        writePlot(m_plot, m_folder / "plot");
    } catch (const PlotError &error) {
        message = error.what();
    }
    ::setenv("PATH", path.c_str(), 1);
    EXPECT_NE(message.find("gnuplot-nox"), std::string::npos) << message;
}

TEST_F(WritePlot, PassesOnWhatGnuplotComplainsOf) {
    m_plot.series.clear(); // nothing to draw
    EXPECT_THROW(writePlot(m_plot, m_folder / "plot"), PlotError);
    EXPECT_THROW(writePlot(m_plot, m_folder / "none" / "plot"), PlotError);
}

} // namespace
} // namespace plot
