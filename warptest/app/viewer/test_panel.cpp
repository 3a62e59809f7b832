// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>

#include <imgui/imgui.h>
#include <viewer/test_panel.h>
#include <window/style.h>

namespace viewer {

namespace {

using battery::Status;

const ImVec4 &colorOf(Status status) {
    const window::Palette &colors = window::palette();
    switch (status) {
    case Status::Pass:
        return colors.pass;
    case Status::Fail:
        return colors.fail;
    case Status::Inconclusive:
        return colors.check;
    case Status::NotRun:
        break;
    }
    return colors.muted;
}

void wrapped(const std::string &text) {
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
}

void colored(const ImVec4 &color, const std::string &text) {
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    wrapped(text);
    ImGui::PopStyleColor();
}

void drawHealth(const std::vector<battery::TestRow> &rows) {
    if (rows.empty() || !ImGui::BeginTable("health", 4,
                                           ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerH |
                                               ImGuiTableFlags_SizingStretchProp)) {
        return;
    }
    for (const char *title : {"Health", "found", "expected"}) {
        ImGui::TableSetupColumn(title);
    }
    ImGui::TableSetupColumn("##verdict", ImGuiTableColumnFlags_WidthFixed,
                            ImGui::CalcTextSize(label(Status::Inconclusive)).x);
    ImGui::TableHeadersRow();
    for (const battery::TestRow &row : rows) {
        ImGui::TableNextRow();
        for (const std::string *cell : {&row.name, &row.value, &row.expected}) {
            ImGui::TableNextColumn();
            wrapped(*cell);
        }
        ImGui::TableNextColumn();
        colored(colorOf(row.status), label(row.status));
    }
    ImGui::EndTable();
}

void drawError(const char *what, const std::string &message) {
    if (!message.empty()) {
        colored(window::palette().fail, fmt::format("✖ {}:", what));
        wrapped(message);
        ImGui::Spacing();
    }
}

} // namespace

void TestPanel::drawReport(const std::shared_ptr<const TestReport> &report, bool stale,
                           bool errorIsShown) {
    if (stale) {
        colored(window::palette().check,
                "▲ of other settings than those on the left; run again (R)");
    }
    colored(colorOf(report->result.verdict),
            fmt::format("{}: {}", label(report->result.verdict), report->result.headline));
    if (!errorIsShown) {
        drawError("it threw", report->result.error);
    }
    for (const std::string &remark : report->result.remarks) {
        ImGui::Bullet();
        wrapped(remark);
    }
    if (!report->maps.observed.empty()) {
        const float room = ImGui::GetContentRegionAvail().x - 5.5F * ImGui::GetFontSize();
        m_maps.draw(std::shared_ptr<const battery::Maps>(report, &report->maps),
                    std::clamp(room / 2.0F, 60.0F, 14.0F * ImGui::GetFontSize()));
    }
    drawHealth(report->result.rows);
    if (!report->result.power.empty()) {
        ImGui::Spacing();
        wrapped(report->result.power);
    }
}

void TestPanel::draw(ViewModel &model) {
    const Cloud &cloud = model.cloud();
    drawError("the warp threw", cloud.warpError);
    drawError("the density threw", cloud.densityError);
    Runner &runner = model.runner();
    if (runner.isBusy()) {
        ImGui::ProgressBar(static_cast<float>(runner.progress()), ImVec2(-1.0F, 0.0F));
    }
    const std::shared_ptr<const TestReport> report = model.report();
    if (report == nullptr) {
        colored(window::palette().muted,
                fmt::format("{}: press R to test this warp, A to test all", label(Status::NotRun)));
    } else {
        const std::string &error = report->result.error;
        drawReport(report, model.isStale(*report),
                   error == cloud.warpError || error == cloud.densityError);
    }
    bool others = false;
    for (std::size_t i = 0; i < model.subjects().size(); ++i) {
        others = others || (i != model.settings().warp && runner.report(i) != nullptr);
    }
    if (!others) {
        return;
    }
    ImGui::Spacing();
    ImGui::Separator();
    ImGui::TextUnformatted("All warps");
    for (std::size_t i = 0; i < model.subjects().size(); ++i) {
        if (const auto other = runner.report(i)) {
            colored(colorOf(other->result.verdict),
                    fmt::format("{}  {}", label(other->result.verdict), model.subjects()[i].name));
        }
    }
}

} // namespace viewer
