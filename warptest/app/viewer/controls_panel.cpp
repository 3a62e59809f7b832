// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <span>

#include <imgui/imgui.h>
#include <viewer/controls_panel.h>

namespace viewer {

namespace {

constexpr float kTypedWidth = 6.5F; ///< of fields with typed numbers, in heights of the font

/// A list of names with the choice as its value.
template <typename Name>
bool choose(const char *label, std::size_t &choice, std::size_t count, const Name &name) {
    bool changed = false;
    ImGui::TextUnformatted(label);
    ImGui::SetNextItemWidth(-1.0F);
    if (ImGui::BeginCombo(fmt::format("##{}", label).c_str(), name(choice),
                          ImGuiComboFlags_HeightLargest)) {
        for (std::size_t i = 0; i < count; ++i) {
            if (ImGui::Selectable(name(i), i == choice)) {
                choice = i;
                changed = true;
            }
            if (i == choice) {
                ImGui::SetItemDefaultFocus();
            }
        }
        ImGui::EndCombo();
    }
    return changed;
}

template <typename Enum>
void chooseEnum(const char *label, Enum &value, std::span<const char *const> names) {
    auto choice = static_cast<std::size_t>(value);
    if (choose(label, choice, names.size(), [&](std::size_t i) { return names[i]; })) {
        value = static_cast<Enum>(choice);
    }
}

/// The slider's width beside a field for typing.
void narrowSlider() {
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - kTypedWidth * ImGui::GetFontSize() -
                            ImGui::GetStyle().ItemSpacing.x);
}

void typedWidth() {
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1.0F);
}

void drawCount(Settings &settings) {
    ImGui::TextUnformatted("Number of points");
    int power = static_cast<int>(std::bit_width(settings.count)) - 1;
    narrowSlider();
    if (ImGui::SliderInt("##power", &power, kMinLogCount, kMaxLogCount, "2^%d",
                         ImGuiSliderFlags_AlwaysClamp)) {
        settings.count = std::size_t{1} << static_cast<unsigned>(power);
    }
    typedWidth();
    auto count = static_cast<int>(settings.count);
    if (ImGui::InputInt("##count", &count, 0, 0, ImGuiInputTextFlags_EnterReturnsTrue)) {
        settings.count = static_cast<std::size_t>(std::max(count, 1));
    }
}

void drawSeed(Settings &settings) {
    ImGui::TextUnformatted("Seed");
    const float button = 5.0F * ImGui::GetFontSize();
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - button);
    std::uint64_t seed = settings.seed;
    if (ImGui::InputScalar("##seed", ImGuiDataType_U64, &seed, nullptr, nullptr, nullptr,
                           ImGuiInputTextFlags_EnterReturnsTrue)) {
        settings.seed = seed;
    }
    ImGui::SameLine();
    if (ImGui::Button("next", ImVec2(-1.0F, 0.0F))) {
        ++settings.seed;
    }
}

void drawButtons(ViewModel &model) {
    Runner &runner = model.runner();
    const ImVec2 wide(-1.0F, 0.0F);
    if (runner.isBusy()) {
        if (ImGui::Button("Cancel  (Esc)", wide)) {
            runner.cancel();
        }
        ImGui::ProgressBar(static_cast<float>(runner.progress()), wide);
        return;
    }
    if (ImGui::Button("Run the test  (R)", wide)) {
        model.runOne();
    }
    if (ImGui::Button("Run all warps  (A)", wide)) {
        model.runAll();
    }
    if (ImGui::Button("Save evidence  (S)", wide)) {
        model.save();
    }
}

} // namespace

void ControlsPanel::drawParameter(Settings &settings, const Subject &subject) {
    if (!subject.truth->hasParameter) {
        m_focusParameter = false;
        return;
    }
    ImGui::TextUnformatted("Roughness α  (E)");
    narrowSlider();
    ImGui::SliderScalar("##alpha", ImGuiDataType_Double, &settings.parameter, &kMinParameter,
                        &kMaxParameter, "%.4f",
                        ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic);
    typedWidth();
    if (m_focusParameter) {
        ImGui::SetKeyboardFocusHere();
        m_focusParameter = false;
    }
    double typed = settings.parameter;
    if (ImGui::InputDouble("##typed alpha", &typed, 0.0, 0.0, "%.9g",
                           ImGuiInputTextFlags_EnterReturnsTrue |
                               ImGuiInputTextFlags_AutoSelectAll)) {
        settings.parameter = typed;
    }
}

void ControlsPanel::draw(ViewModel &model) {
    const std::vector<Subject> &subjects = model.subjects();
    std::size_t warp = model.settings().warp;
    if (choose("Warp  (N, P)", warp, subjects.size(),
               [&](std::size_t i) { return subjects[i].name.c_str(); })) {
        model.chooseWarp(warp);
    }
    Settings settings = model.settings();
    const Settings before = settings;
    drawParameter(settings, subjects[settings.warp]);
    chooseEnum("Points", settings.points, kPointSetNames);
    drawCount(settings);
    drawSeed(settings);
    chooseEnum("Colour by", settings.colorBy, kColorByNames);
    ImGui::Checkbox("Warped grid  (G)", &settings.grid);
    if (settings != before) {
        model.change(settings);
    }
    ImGui::Separator();
    drawButtons(model);
}

} // namespace viewer
