// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <imgui/imgui.h>
#include <viewer/samples_panel.h>
#include <viewer/vertices.h>
#include <window/color_map.h>
#include <window/style.h>

namespace viewer {

namespace {

constexpr float kTurnStep = 0.2F; ///< [radians] of one press of a button
constexpr float kZoomStep = 1.15F;
constexpr float kFlatMargin = 1.06F; ///< of the view's half side, in half sides of the square
constexpr float kHoverRadius = 0.02F;

std::uint32_t shade(const ImVec4 &color, double alpha) {
    return window::packColor(static_cast<double>(color.x), static_cast<double>(color.y),
                             static_cast<double>(color.z), alpha);
}

LineColors lineColors() {
    const window::Palette &colors = window::palette();
    return {shade(colors.ink, 0.9), shade(colors.ink, 0.35), shade(colors.fail, 0.9),
            shade(colors.muted, 0.12)};
}

float pointSize(std::size_t count, float scale) {
    return std::clamp(6.0F - 0.3F * std::log2(static_cast<float>(std::max<std::size_t>(count, 1))),
                      1.0F, 4.0F) *
           scale;
}

std::string describe(const Cloud &cloud, std::size_t i) {
    const battery::Input &in = cloud.inputs[i];
    std::string text = fmt::format("({:.4f}, {:.4f})", in.u, in.v);
    if (i < cloud.outputs.size()) {
        const battery::Output &out = cloud.outputs[i];
        text += fmt::format(" → ({:.4f}, {:.4f}, {:.4f})", out.x, out.y, out.z);
    }
    if (i < cloud.densities.size()) {
        text += fmt::format("\npdf = {:.6g}, exact {:.6g}", cloud.densities[i], cloud.exact[i]);
    }
    return text;
}

/// Shows the texts of the vertex next to the pointer, the nearest to the eye of those.
void drawHover(const Cloud &cloud, const std::vector<window::Vertex> &points,
               const window::Matrix &transform, std::array<float, 2> pointer) {
    std::size_t nearest = points.size();
    float best = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::array<float, 3> at = project(transform, points[i].x, points[i].y, points[i].z);
        const float distance = std::hypot(at[0] - pointer[0], at[1] - pointer[1]);
        if (distance < kHoverRadius && distance + at[2] < best) {
            best = distance + at[2];
            nearest = i;
        }
    }
    if (nearest < points.size()) {
        ImGui::SetTooltip("%s", describe(cloud, nearest).c_str());
    }
}

/// The pointer in the item that was drawn last, [-1, 1]^2 with y up.
std::array<float, 2> pointerIn(const ImVec2 &corner, float width, float height) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    return {2.0F * (mouse.x - corner.x) / width - 1.0F,
            1.0F - 2.0F * (mouse.y - corner.y) / height};
}

/// What the colours mean, with the ends of their scale.
std::string colorLegend(const Cloud &cloud, ColorBy by) {
    float largest = 0.0F;
    for (const float density : cloud.densities) {
        largest = std::isfinite(density) ? std::max(largest, density) : largest;
    }
    switch (by) {
    case ColorBy::Density:
        return fmt::format("colour: returned density, dark 0 … green {:.4g}", largest);
    case ColorBy::Order:
        return "colour: order, dark first … green last";
    case ColorBy::Error:
        return "colour: relative density error, dark 0 … green 1 % and more";
    case ColorBy::Plain:
        break;
    }
    return "";
}

} // namespace

void SamplesPanel::uploadSpace(ViewModel &model) {
    const LineColors colors = lineColors();
    m_space.setPoints(spacePoints(model, colors));
    m_space.setLines(spaceLines(model, colors));
    m_spaceRevision = model.revision();
}

void SamplesPanel::uploadFlat(ViewModel &model, Brush::View which,
                              const battery::DomainMap &domain) {
    const LineColors colors = lineColors();
    FlatView &view = m_flat.at(static_cast<std::size_t>(which));
    view.points.setPoints(flatPoints(model, which, domain, colors));
    view.points.setLines(flatLines(model, which, domain, colors));
}

void SamplesPanel::drawTurnButtons(bool directions) {
    struct Step {
        const char *label;
        const char *help;
        float aboutX, aboutY, zoom;
    };

    static constexpr Step kSteps[] = {
        {"←", "turn left", 0.0F, -kTurnStep, 1.0F}, {"→", "turn right", 0.0F, kTurnStep, 1.0F},
        {"↑", "tilt back", -kTurnStep, 0.0F, 1.0F}, {"↓", "tilt forward", kTurnStep, 0.0F, 1.0F},
        {"+", "closer", 0.0F, 0.0F, kZoomStep},     {"−", "farther", 0.0F, 0.0F, 1.0F / kZoomStep}};
    ImGui::PushButtonRepeat(true);
    for (const Step &step : kSteps) {
        if (ImGui::Button(step.label, ImVec2(2.0F * ImGui::GetFontSize(), 0.0F))) {
            m_ball.turn(step.aboutX, step.aboutY);
            m_ball.zoom(step.zoom);
        }
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s", step.help);
        }
        ImGui::SameLine();
    }
    ImGui::PopButtonRepeat();
    if (ImGui::Button("reset view")) {
        m_ball.reset(directions);
    }
}

void SamplesPanel::handleSpaceMouse(float width, float height) {
    const ImGuiIO &io = ImGui::GetIO();
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0.0F)) {
        const float side = std::min(width, height) / 2.0F;
        const ImVec2 middle((ImGui::GetItemRectMin().x + ImGui::GetItemRectMax().x) / 2.0F,
                            (ImGui::GetItemRectMin().y + ImGui::GetItemRectMax().y) / 2.0F);
        const std::array<float, 2> now{(io.MousePos.x - middle.x) / side,
                                       (middle.y - io.MousePos.y) / side};
        m_ball.drag({now[0] - io.MouseDelta.x / side, now[1] + io.MouseDelta.y / side}, now);
    }
    if (ImGui::IsItemHovered() && io.MouseWheel != 0.0F) {
        m_ball.zoom(std::pow(kZoomStep, io.MouseWheel));
    }
}

void SamplesPanel::drawSpace(ViewModel &model, const window::Frame &frame) {
    const bool directions = model.subject().truth->dimension == 3;
    if (m_warp != model.settings().warp) {
        m_warp = model.settings().warp;
        const battery::DomainMap domain = battery::makeDomainMap(*model.subject().truth);
        const auto middle = [&](std::size_t axis) {
            return static_cast<float>((domain.low.at(axis) + domain.high.at(axis)) / 2.0);
        };
        if (directions) {
            m_ball.setCenter({0.0F, 0.0F, middle(1) * 0.8F}, 1.35F);
        } else {
            m_ball.setCenter({middle(0), middle(1), 0.0F},
                             static_cast<float>(domain.high[0] - domain.low[0]) * 0.78F);
        }
        m_ball.reset(directions);
    }
    if (m_spaceRevision != model.revision() || m_theme != frame.theme) {
        uploadSpace(model);
        m_flat[0].revision = m_flat[1].revision = 0;
        m_theme = frame.theme;
    }
    drawTurnButtons(directions);
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float legend = ImGui::GetTextLineHeightWithSpacing();
    const float width = std::max(room.x, 64.0F);
    const float height = std::max(room.y - legend, 64.0F);
    const window::Matrix transform = m_ball.transform(width / height);
    const Cloud &cloud = model.cloud();
    ImTextureID texture =
        m_space.draw(static_cast<int>(width), static_cast<int>(height), transform,
                     pointSize(cloud.outputs.size(), frame.scale), window::palette().paper);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("space", ImVec2(width, height));
    ImDrawList &list = *ImGui::GetWindowDrawList();
    list.AddImage(texture, corner, ImVec2(corner.x + width, corner.y + height), ImVec2(0, 1),
                  ImVec2(1, 0));
    handleSpaceMouse(width, height);
    static constexpr const char *kAxes[] = {"x", "y", "z"};
    for (int axis = 0; axis < (directions ? 3 : 2); ++axis) {
        const float end = 1.25F;
        const std::array<float, 3> at = project(transform, axis == 0 ? end : 0.0F,
                                                axis == 1 ? end : 0.0F, axis == 2 ? end : 0.0F);
        list.AddText(ImVec2(corner.x + (at[0] + 1.0F) / 2.0F * width,
                            corner.y + (1.0F - at[1]) / 2.0F * height - ImGui::GetFontSize() / 2),
                     shade(window::palette().ink, 1.0), kAxes[axis]);
    }
    if (ImGui::IsItemHovered() && !ImGui::IsItemActive()) {
        drawHover(cloud, spacePoints(model, lineColors()), transform,
                  pointerIn(corner, width, height));
    }
    ImGui::TextDisabled("%s", colorLegend(cloud, model.settings().colorBy).c_str());
}

void SamplesPanel::drawFlat(ViewModel &model, const window::Frame &frame, Brush::View which) {
    FlatView &view = m_flat.at(static_cast<std::size_t>(which));
    const battery::DomainMap domain = battery::makeDomainMap(*model.subject().truth);
    if (view.revision != model.revision() + 1) { // 0: never
        uploadFlat(model, which, domain);
        view.revision = model.revision() + 1;
    }
    ImGui::TextDisabled("Drag over points to light them in every view; a click lets go.");
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float side =
        std::max(64.0F, std::min(room.x, room.y - ImGui::GetTextLineHeightWithSpacing()));
    // [0, 1]^2 with a margin, whatever the coordinates are
    const float scale = 2.0F / kFlatMargin;
    const window::Matrix transform{scale, 0, 0, 0, 0,          scale,      0, 0,
                                   0,     0, 1, 0, -scale / 2, -scale / 2, 0, 1};
    const Cloud &cloud = model.cloud();
    ImTextureID texture =
        view.points.draw(static_cast<int>(side), static_cast<int>(side), transform,
                         pointSize(cloud.inputs.size(), frame.scale), window::palette().paper);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("flat", ImVec2(side, side));
    ImDrawList &list = *ImGui::GetWindowDrawList();
    list.AddImage(texture, corner, ImVec2(corner.x + side, corner.y + side), ImVec2(0, 1),
                  ImVec2(1, 0));
    const std::array<float, 2> pointer = pointerIn(corner, side, side);
    const std::array<double, 2> place{static_cast<double>(pointer[0] / scale) + 0.5,
                                      static_cast<double>(pointer[1] / scale) + 0.5};
    if (ImGui::IsItemActivated()) {
        view.brushStart = place;
    }
    if (view.brushStart && ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left)) {
        model.setBrush(Brush{which, *view.brushStart, place});
    }
    if (view.brushStart && ImGui::IsItemDeactivated()) {
        const ImVec2 moved = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left);
        if (moved.x == 0.0F && moved.y == 0.0F && model.brush()) {
            model.setBrush(std::nullopt);
        }
        view.brushStart.reset();
    }
    if (model.brush() && model.brush()->view == which) {
        const auto toScreen = [&](const std::array<double, 2> &at) {
            return ImVec2(corner.x + (static_cast<float>(at[0] - 0.5) * scale + 1.0F) / 2.0F * side,
                          corner.y +
                              (1.0F - static_cast<float>(at[1] - 0.5) * scale) / 2.0F * side);
        };
        list.AddRect(toScreen(model.brush()->from), toScreen(model.brush()->to),
                     shade(window::palette().check, 1.0), 0.0F, 0, 2.0F);
    }
    if (ImGui::IsItemHovered() && !ImGui::IsItemActive()) {
        drawHover(cloud, flatPoints(model, which, domain, lineColors()), transform, pointer);
    }
    const std::string axes = which == Brush::View::Square
                                 ? "→ u in [0, 1), ↑ v in [0, 1)"
                                 : fmt::format("→ {} in [{:.3g}, {:.3g}], ↑ {} in [{:.3g}, {:.3g}]",
                                               domain.xLabel, domain.low[0], domain.high[0],
                                               domain.yLabel, domain.low[1], domain.high[1]);
    ImGui::TextDisabled("%s", axes.c_str());
}

void SamplesPanel::draw(ViewModel &model, const window::Frame &frame) {
    if (!ImGui::BeginTabBar("views")) {
        return;
    }
    static constexpr const char *kTabs[] = {"3-D  (1)", "Unit square  (2)", "Domain map  (3)"};
    for (int tab = 0; tab < 3; ++tab) {
        const ImGuiTabItemFlags flags =
            m_wantedTab == tab ? ImGuiTabItemFlags_SetSelected : ImGuiTabItemFlags_None;
        if (ImGui::BeginTabItem(kTabs[tab], nullptr, flags)) {
            if (tab == 0) {
                drawSpace(model, frame);
            } else {
                drawFlat(model, frame, tab == 1 ? Brush::View::Square : Brush::View::Domain);
            }
            ImGui::EndTabItem();
        }
    }
    m_wantedTab = -1;
    ImGui::EndTabBar();
}

void SamplesPanel::release() {
    m_space.release();
    m_spaceRevision.reset();
    for (FlatView &view : m_flat) {
        view.points.release();
        view.revision = 0;
    }
}

} // namespace viewer
