// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>

#include <imgui/imgui.h>
#include <viewer/map_plot.h>
#include <window/color_map.h>
#include <window/style.h>

namespace viewer {

namespace {

constexpr double kResidualRange = 4.0; ///< standard deviations at the ends of the colours
constexpr std::uint32_t kSparseColor = 0xff808080;

struct Picture {
    const char *title;
    const char *id;
    bool isSigned;
};

constexpr std::array<Picture, 3> kPictures{{{"Observed", "observed", false},
                                            {"Expected", "expected", false},
                                            {"Residual (O−E)/√E", "residual", true}}};

const std::vector<double> &valuesOf(const battery::Maps &maps, std::size_t which) {
    return which == 0 ? maps.observed : which == 1 ? maps.expected : maps.residual;
}

float textWidth(const std::string &text) {
    return ImGui::CalcTextSize(text.c_str()).x;
}

} // namespace

void drawColorBar(bool isSigned, double high, float height) {
    constexpr int kSteps = 32;
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetFontSize() * 0.7F;
    const float step = height / kSteps;
    for (int i = 0; i < kSteps; ++i) {
        const double t = 1.0 - (i + 0.5) / kSteps;
        const float y = at.y + static_cast<float>(i) * step;
        list.AddRectFilled(ImVec2(at.x, y), ImVec2(at.x + width, y + step),
                           isSigned ? window::diverging(2.0 * t - 1.0) : window::viridis(t));
    }
    const ImU32 ink = ImGui::GetColorU32(ImGuiCol_Text);
    const std::array<std::string, 3> ticks =
        isSigned ? std::array<std::string, 3>{fmt::format("+{:.3g} σ", high), "0",
                                              fmt::format("−{:.3g} σ", high)}
                 : std::array<std::string, 3>{fmt::format("{:.4g}", high),
                                              fmt::format("{:.4g}", high / 2.0), "0"};
    float widest = 0.0F;
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        const float y = at.y + (height - ImGui::GetFontSize()) * static_cast<float>(i) / 2.0F;
        list.AddText(ImVec2(at.x + width * 1.4F, y), ink, ticks.at(i).c_str());
        widest = std::max(widest, textWidth(ticks.at(i)));
    }
    ImGui::Dummy(ImVec2(width * 1.4F + widest, height));
}

void MapPlot::upload() {
    for (std::size_t which = 0; which < 3; ++which) {
        const std::vector<double> &values = valuesOf(*m_maps, which);
        std::vector<std::uint32_t> pixels(values.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
            const bool isSigned = kPictures.at(which).isSigned;
            pixels[i] = isSigned ? window::diverging(values[i] / kResidualRange)
                                 : window::viridis(values[i] / std::max(m_maps->largest, 1.0));
            if (isSigned && m_maps->sparse[i]) {
                pixels[i] = kSparseColor;
            }
        }
        m_textures.at(which).upload(m_maps->side, m_maps->side, pixels);
    }
}

void MapPlot::drawMap(std::size_t which, float side) {
    const Picture &picture = kPictures.at(which);
    const battery::DomainMap &domain = m_maps->domain;
    ImGui::BeginGroup();
    ImGui::TextUnformatted(picture.title);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    // row 0 is at the bottom
    ImGui::Image(m_textures.at(which).id(), ImVec2(side, side), ImVec2(0, 1), ImVec2(1, 0));
    if (ImGui::IsItemHovered()) {
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        const int cell = battery::cellAt({static_cast<double>((mouse.x - at.x) / side),
                                          static_cast<double>(1.0F - (mouse.y - at.y) / side)},
                                         m_maps->side);
        if (cell >= 0) {
            m_cell = {cell % m_maps->side, cell / m_maps->side};
            ImGui::BeginTooltip();
            drawCellText();
            ImGui::EndTooltip();
        }
    }
    const float unit = side / static_cast<float>(m_maps->side);
    const ImVec2 corner(at.x + static_cast<float>(m_cell[0]) * unit,
                        at.y + side - static_cast<float>(m_cell[1] + 1) * unit);
    ImGui::GetWindowDrawList()->AddRect(corner, ImVec2(corner.x + unit, corner.y + unit),
                                        ImGui::GetColorU32(window::palette().fail), 0.0F, 0, 2.0F);
    const std::string axes =
        fmt::format("{} {:.3g} … {:.3g} →\n{} {:.3g} … {:.3g} ↑", domain.xLabel, domain.low[0],
                    domain.high[0], domain.yLabel, domain.low[1], domain.high[1]);
    ImGui::TextDisabled("%s", axes.c_str());
    ImGui::EndGroup();
}

void MapPlot::drawCellText() const {
    const auto i = static_cast<std::size_t>(m_cell[1]) * static_cast<std::size_t>(m_maps->side) +
                   static_cast<std::size_t>(m_cell[0]);
    const battery::DomainMap &domain = m_maps->domain;
    const auto coordinate = [&](std::size_t axis) {
        return domain.low.at(axis) + (domain.high.at(axis) - domain.low.at(axis)) *
                                         (static_cast<double>(m_cell.at(axis)) + 0.5) /
                                         m_maps->side;
    };
    const std::string place = fmt::format("{} {:.3f}, {} {:.3f}", domain.xLabel, coordinate(0),
                                          domain.yLabel, coordinate(1));
    ImGui::TextUnformatted(place.c_str());
    const std::string residual =
        m_maps->sparse[i] ? fmt::format("fewer than {:.0f} expected", battery::kMinExpected)
                          : fmt::format("residual {:+.2f} σ", m_maps->residual[i]);
    const std::string values = fmt::format("observed {:.0f}, expected {:.1f}, {}",
                                           m_maps->observed[i], m_maps->expected[i], residual);
    ImGui::TextUnformatted(values.c_str());
}

void MapPlot::draw(const std::shared_ptr<const battery::Maps> &maps, float side) {
    if (maps != m_maps) {
        m_maps = maps;
        const auto worst = static_cast<int>(battery::worstCell(*maps));
        m_cell = {worst % maps->side, worst / maps->side};
        upload();
    }
    const ImGuiStyle &style = ImGui::GetStyle();
    drawMap(0, side);
    ImGui::SameLine();
    drawMap(1, side);
    ImGui::SameLine(0.0F, style.ItemInnerSpacing.x);
    ImGui::BeginGroup();
    ImGui::TextUnformatted("");
    drawColorBar(false, m_maps->largest, side);
    ImGui::EndGroup();

    drawMap(2, side);
    ImGui::SameLine(0.0F, style.ItemInnerSpacing.x);
    ImGui::BeginGroup();
    ImGui::TextUnformatted("");
    drawColorBar(true, kResidualRange, side);
    ImGui::EndGroup();
    ImGui::SameLine();
    ImGui::BeginGroup();
    ImGui::TextUnformatted("Cell");
    ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x);
    ImGui::SliderInt("##column", &m_cell[0], 0, m_maps->side - 1, "column %d",
                     ImGuiSliderFlags_AlwaysClamp);
    ImGui::SliderInt("##row", &m_cell[1], 0, m_maps->side - 1, "row %d",
                     ImGuiSliderFlags_AlwaysClamp);
    ImGui::PopItemWidth();
    ImGui::PushTextWrapPos(0.0F);
    drawCellText();
    ImGui::PopTextWrapPos();
    ImGui::EndGroup();
    const std::string legend =
        fmt::format("{} points, {} outside of the map; grey: fewer than {:.0f} expected",
                    m_maps->points, m_maps->outside, battery::kMinExpected);
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextDisabled("%s", legend.c_str());
    ImGui::PopTextWrapPos();
}

void MapPlot::release() {
    for (window::Texture &texture : m_textures) {
        texture.release();
    }
    m_maps.reset();
}

} // namespace viewer
