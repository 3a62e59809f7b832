// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include <imgui/imgui.h>
#include <preview/image_panel.h>
#include <window/style.h>

namespace preview {

namespace {

constexpr double kWheelStep = 1.25;
constexpr double kValueZoom = 44; ///< points of a pixel, at scale 1, that has room for its values
constexpr float kValueSize = 11;  ///< height of their text
constexpr float kRing = 7;        ///< radius around a faulty pixel
constexpr ImU32 kShade = 0xb0000000;

ImVec2 at(const ViewModel &model, const ImVec2 &corner, double column, double row) {
    const std::array<double, 2> place = model.toArea(column, row);
    return {corner.x + static_cast<float>(place[0]), corner.y + static_cast<float>(place[1])};
}

/// A line that is seen on any colour.
void outline(ImDrawList &list, const ImVec2 &from, const ImVec2 &to, ImU32 color, float width) {
    list.AddRect(from, to, kShade, 0, 0, 3 * width);
    list.AddRect(from, to, color, 0, 0, width);
}

} // namespace

void ImagePanel::draw(ViewModel &model, float scale) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 available = ImGui::GetContentRegionAvail();
    const ImVec2 size(std::max(available.x, 1.0f), std::max(available.y, 1.0f));
    model.setArea(static_cast<double>(size.x), static_cast<double>(size.y));
    ImGui::InvisibleButton("image", size);
    handleMouse(model, corner);
    ImDrawList &list = *ImGui::GetWindowDrawList();
    if (!model.hasImage()) {
        list.AddText(corner, ImGui::GetColorU32(ImGuiCol_TextDisabled),
                     "the first pass is being rendered");
        return;
    }
    const std::vector<std::uint32_t> &colors = model.colors();
    const auto columns = static_cast<int>(model.image().cols());
    const auto rows = static_cast<int>(model.image().rows());
    if (m_texture.isEmpty() || m_revision != model.revision()) {
        m_texture.upload(columns, rows, colors);
        m_revision = model.revision();
    }
    list.PushClipRect(corner, ImVec2(corner.x + size.x, corner.y + size.y), true);
    list.AddImage(m_texture.id(), at(model, corner, 0, 0), at(model, corner, columns, rows));
    if (model.zoom() >= kValueZoom * static_cast<double>(scale))
        drawValues(model, corner, size, scale);
    drawOverlays(model, corner, scale);
    list.PopClipRect();
}

void ImagePanel::handleMouse(ViewModel &model, const ImVec2 &corner) {
    const ImGuiIO &io = ImGui::GetIO();
    const auto x = static_cast<double>(io.MousePos.x - corner.x);
    const auto y = static_cast<double>(io.MousePos.y - corner.y);
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left))
        model.panBy(static_cast<double>(io.MouseDelta.x), static_cast<double>(io.MouseDelta.y));
    if (!ImGui::IsItemHovered())
        return;
    if (io.MouseWheel != 0)
        model.zoomBy(std::pow(kWheelStep, static_cast<double>(io.MouseWheel)), x, y);
    if (io.MouseDelta.x != 0 || io.MouseDelta.y != 0) // else the keys have moved the cursor
        model.pointAt(x, y);
}

void ImagePanel::drawValues(const ViewModel &model, const ImVec2 &corner, const ImVec2 &size,
                            float scale) const {
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const std::array<double, 2> first = model.toImage(0, 0);
    const std::array<double, 2> last =
        model.toImage(static_cast<double>(size.x), static_cast<double>(size.y));
    const auto clampTo = [](double value, Eigen::Index count) {
        return std::clamp<Eigen::Index>(static_cast<Eigen::Index>(std::floor(value)), 0, count - 1);
    };
    const nori::Bitmap &image = model.image();
    const float height = kValueSize * scale;
    for (Eigen::Index y = clampTo(first[1], image.rows()); y <= clampTo(last[1], image.rows());
         ++y) {
        for (Eigen::Index x = clampTo(first[0], image.cols()); x <= clampTo(last[0], image.cols());
             ++x) {
            const nori::Color3f &value = image.coeff(y, x);
            const std::string text =
                fmt::format("{:.3g}\n{:.3g}\n{:.3g}", value[0], value[1], value[2]);
            ImVec2 place = at(model, corner, static_cast<double>(x), static_cast<double>(y));
            place = ImVec2(place.x + 3 * scale, place.y + 2 * scale);
            list.AddText(ImGui::GetFont(), height, ImVec2(place.x + 1, place.y + 1), 0xff000000,
                         text.c_str());
            list.AddText(ImGui::GetFont(), height, place, 0xffffffff, text.c_str());
        }
    }
}

void ImagePanel::drawOverlays(const ViewModel &model, const ImVec2 &corner, float scale) const {
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const window::Palette &palette = window::palette();
    if (m_blocks && model.job() != nullptr) {
        for (const std::array<int, 4> &block : model.job()->activeBlocks())
            outline(list, at(model, corner, block[0], block[1]),
                    at(model, corner, block[0] + block[2], block[1] + block[3]),
                    ImGui::GetColorU32(palette.accent), scale);
    }
    if (model.look().markFaulty) {
        for (const nori::Point2i &pixel : model.summary().faulty) {
            const ImVec2 center = at(model, corner, pixel.x() + 0.5, pixel.y() + 0.5);
            list.AddCircle(center, kRing * scale, kShade, 0, 4 * scale);
            list.AddCircle(center, kRing * scale, 0xffff80ff, 0, 2 * scale);
        }
    }
    const auto rows = static_cast<double>(model.image().rows());
    if (model.look().view == View::Split && model.hasReference()) {
        const double column =
            std::round(model.look().split * static_cast<double>(model.image().cols()));
        const ImVec2 from = at(model, corner, column, 0);
        const ImVec2 to = at(model, corner, column, rows);
        list.AddLine(from, to, kShade, 4 * scale);
        list.AddLine(from, to, 0xffffffff, 1.5f * scale);
    }
    if (model.cursor()) {
        const nori::Point2i &pixel = *model.cursor();
        outline(list, at(model, corner, pixel.x(), pixel.y()),
                at(model, corner, pixel.x() + 1, pixel.y() + 1), ImGui::GetColorU32(palette.check),
                scale);
    }
}

} // namespace preview
