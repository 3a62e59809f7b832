// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include <imgui/imgui.h>
#include <preview/side_panel.h>
#include <window/color_map.h>
#include <window/style.h>

namespace preview {

namespace {

constexpr float kPlotHeight = 150; ///< at scale 1
constexpr int kBarSteps = 64;

void text(const std::string &line) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(line.c_str());
    ImGui::PopTextWrapPos();
}

void heading(const char *name) {
    ImGui::Spacing();
    ImGui::TextColored(window::palette().accent, "%s", name);
}

void tableRow(const char *name, const std::array<double, 3> &values) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(name);
    for (const double value : values) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(fmt::format("{:.4g}", value).c_str());
    }
}

void drawSummary(const ImageSummary &summary) {
    if (ImGui::BeginTable("channels", 4)) {
        for (const char *name : {"", "R", "G", "B"})
            ImGui::TableSetupColumn(name);
        ImGui::TableHeadersRow();
        tableRow("mean", summary.mean);
        tableRow("min", summary.smallest);
        tableRow("max", summary.largest);
        ImGui::EndTable();
    }
    const size_t faulty = summary.notANumber + summary.infinite + summary.negative;
    const window::Palette &palette = window::palette();
    const std::string line =
        fmt::format("{} {} NaN, {} infinite, {} negative pixels", faulty > 0 ? "✖" : "✔",
                    summary.notANumber, summary.infinite, summary.negative);
    ImGui::PushTextWrapPos(0);
    ImGui::TextColored(faulty > 0 ? palette.fail : palette.pass, "%s", line.c_str());
    ImGui::PopTextWrapPos();
}

/// What the colours of the differences mean.
void drawLegend(double exposure) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const float height = ImGui::GetTextLineHeight();
    ImDrawList &list = *ImGui::GetWindowDrawList();
    for (int i = 0; i < kBarSteps; ++i)
        list.AddRectFilled(
            ImVec2(corner.x + width * static_cast<float>(i) / kBarSteps, corner.y),
            ImVec2(corner.x + width * static_cast<float>(i + 1) / kBarSteps, corner.y + height),
            window::diverging(2.0 * (i + 0.5) / kBarSteps - 1.0));
    ImGui::Dummy(ImVec2(width, height));
    const double limit = 100 * std::exp2(-exposure);
    const std::string right = fmt::format("+{:.3g} %", limit);
    ImGui::TextUnformatted(fmt::format("-{:.3g} %", limit).c_str());
    ImGui::SameLine(ImGui::GetCursorPosX() + width - ImGui::CalcTextSize(right.c_str()).x);
    ImGui::TextUnformatted(right.c_str());
}

/// Both axes are logarithmic.
void drawHistory(const std::vector<ErrorPoint> &history, float scale) {
    if (history.size() < 2) {
        ImGui::TextDisabled("drawn while rendering");
        return;
    }
    const auto byError = [](const ErrorPoint &a, const ErrorPoint &b) {
        return a.rmse < b.rmse;
    };
    const double top = std::max_element(history.begin(), history.end(), byError)->rmse;
    const double bottom = std::min_element(history.begin(), history.end(), byError)->rmse;
    const double from = history.front().seconds;
    const double to = history.back().seconds;
    ImGui::TextUnformatted(fmt::format("RMSE {:.3g}", top).c_str());
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size(ImGui::GetContentRegionAvail().x, kPlotHeight * scale);
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const window::Palette &palette = window::palette();
    const ImVec2 end(corner.x + size.x, corner.y + size.y);
    list.AddRectFilled(corner, end, ImGui::GetColorU32(palette.paper));
    list.AddRect(corner, end, ImGui::GetColorU32(palette.muted));
    const auto share = [](double value, double low, double high) {
        const bool isSpread = low > 0 && high > low;
        return static_cast<float>(isSpread ? std::log(value / low) / std::log(high / low) : 0.5);
    };
    std::vector<ImVec2> line;
    line.reserve(history.size());
    for (const ErrorPoint &point : history)
        line.emplace_back(corner.x + size.x * share(point.seconds, from, to),
                          end.y - size.y * share(point.rmse, bottom, top));
    list.AddPolyline(line.data(), static_cast<int>(line.size()), ImGui::GetColorU32(palette.accent),
                     0, 2 * scale);
    ImGui::Dummy(size);
    const std::string right = fmt::format("{:.3g} s", to);
    ImGui::TextUnformatted(fmt::format("{:.3g}   {:.2g} s", bottom, from).c_str());
    ImGui::SameLine(ImGui::GetCursorPosX() + size.x - ImGui::CalcTextSize(right.c_str()).x);
    ImGui::TextUnformatted(right.c_str());
}

} // namespace

void drawSidePanel(ViewModel &model, float scale) {
    heading("Pixel");
    for (const std::string &line : model.pixelLines())
        text(line);
    if (model.cursor() && ImGui::Button("Copy  (C)"))
        ImGui::SetClipboardText(model.pixelText().c_str());
    if (model.hasImage()) {
        heading("Image");
        drawSummary(model.summary());
    }
    if (!model.summary().faulty.empty() && ImGui::Button("Next of these  (J)"))
        model.findFaulty();
    heading("Reference");
    text(model.referenceLine());
    if (model.error()) {
        for (const std::string &line : describe(*model.error()))
            text(line);
    }
    if (model.hasReference() && model.look().view == View::Difference) {
        heading("Difference, relative to the reference");
        drawLegend(model.look().exposure);
    }
    if (model.job() != nullptr && model.error()) {
        heading("Error over time, both logarithmic");
        drawHistory(model.history(), scale);
    }
}

} // namespace preview
