// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>
#include <vector>

#include <imgui/imgui.h>
#include <viewer/controls_panel.h>
#include <viewer/samples_panel.h>
#include <viewer/test_panel.h>
#include <viewer/warp_window.h>
#include <window/key_help.h>

namespace viewer {

namespace {

constexpr float kControlsWidth = 270.0F; ///< at scale 1 [pixels]
constexpr float kTestWidth = 420.0F;
constexpr float kNarrow = 1040.0F; ///< below this the columns become tabs

const std::vector<window::KeyHelp> kHelp = {
    {"R", "run the test of this warp"},
    {"A", "run all warps"},
    {"Esc", "cancel"},
    {"S", "save the evidence"},
    {"N, P", "next and previous warp"},
    {"E", "type the parameter (Enter takes it)"},
    {"G", "warped grid"},
    {"1, 2, 3", "the views of the points"},
    {"T", "theme: dark, light, high contrast"},
    {"Ctrl +, Ctrl −", "size of everything"},
    {"Q", "quit"},
    {"?", "this help"},
    {"", "Arrow keys walk through the controls, Space presses, Tab goes to the next field."},
    {"", "In the 3-D view drag to turn, wheel to zoom; in the flat ones drag to brush."},
    {"", "Each part has a twin on the command line: see warptest --help."}};

class WarpWindow : public window::Ui {
public:
    WarpWindow(ViewModel &model, const WindowOptions &options) : m_model(model) {
        m_samples.showTab(options.tab);
    }

    void draw(const window::Frame &frame) override {
        handleKeys(frame);
        ImGui::SetNextWindowPos(ImVec2(0, 0));
        ImGui::SetNextWindowSize(ImVec2(frame.width, frame.height));
        ImGui::Begin("warptest", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoSavedSettings);
        const float status =
            ImGui::GetTextLineHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
        if (frame.width < kNarrow * frame.scale) {
            drawTabs(frame, -status);
        } else {
            drawColumns(frame, -status);
        }
        ImGui::Separator();
        ImGui::TextUnformatted(m_model.statusLine().c_str());
        const char *const hint = "? help";
        ImGui::SameLine(ImGui::GetWindowWidth() - ImGui::CalcTextSize(hint).x -
                        2.0F * ImGui::GetStyle().WindowPadding.x);
        ImGui::TextDisabled("%s", hint);
        ImGui::End();
        window::drawKeyHelp(m_openHelp, kHelp);
    }

    bool isBusy() const override { return m_model.runner().isBusy(); }

    void releaseGraphics() override {
        m_samples.release();
        m_test.release();
    }

private:
    void handleKeys(const window::Frame &frame) {
        const ImGuiIO &io = ImGui::GetIO();
        const int escape = ImGui::GetKeyIndex(ImGuiKey_Escape);
        if (escape >= 0 && ImGui::IsKeyPressed(escape, false) && !io.WantTextInput) {
            m_model.runner().cancel();
        }
        if (io.WantTextInput || io.KeyCtrl || io.KeyAlt) {
            return;
        }
        for (const ImWchar key : io.InputQueueCharacters) {
            press(static_cast<char>(key < 128 ? key : 0), frame);
        }
    }

    void press(char key, const window::Frame &frame) {
        Settings settings = m_model.settings();
        const std::size_t warps = m_model.subjects().size();
        switch (key >= 'A' && key <= 'Z' ? static_cast<char>(key - 'A' + 'a') : key) {
        case 'r':
            m_model.runOne();
            break;
        case 'a':
            m_model.runAll();
            break;
        case 's':
            m_model.save();
            break;
        case 'n':
            m_model.chooseWarp(settings.warp + 1);
            break;
        case 'p':
            m_model.chooseWarp(settings.warp + warps - 1);
            break;
        case 'e':
            m_controls.focusParameter();
            break;
        case 'g':
            settings.grid = !settings.grid;
            m_model.change(settings);
            break;
        case '1':
        case '2':
        case '3':
            m_samples.showTab(key - '1');
            break;
        case 't':
            frame.requests->setTheme = true;
            frame.requests->theme =
                static_cast<window::Theme>((static_cast<int>(frame.theme) + 1) % 3);
            break;
        case 'q':
            frame.requests->close = true;
            break;
        case '?':
            m_openHelp = true;
            break;
        default:
            break;
        }
    }

    void drawColumns(const window::Frame &frame, float bottom) {
        constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NavFlattened;
        const float spacing = ImGui::GetStyle().ItemSpacing.x;
        ImGui::BeginChild("controls", ImVec2(kControlsWidth * frame.scale, bottom), true, kFlags);
        m_controls.draw(m_model);
        ImGui::EndChild();
        ImGui::SameLine();
        const float middle = ImGui::GetContentRegionAvail().x - kTestWidth * frame.scale - spacing;
        ImGui::BeginChild("samples", ImVec2(middle, bottom), true, kFlags);
        m_samples.draw(m_model, frame);
        ImGui::EndChild();
        ImGui::SameLine();
        ImGui::BeginChild("test", ImVec2(0.0F, bottom), true, kFlags);
        m_test.draw(m_model);
        ImGui::EndChild();
    }

    void drawTabs(const window::Frame &frame, float bottom) {
        if (!ImGui::BeginTabBar("columns")) {
            return;
        }
        const auto tab = [&](const char *name, const auto &content) {
            if (ImGui::BeginTabItem(name)) {
                ImGui::BeginChild(name, ImVec2(0.0F, bottom), false, ImGuiWindowFlags_NavFlattened);
                content();
                ImGui::EndChild();
                ImGui::EndTabItem();
            }
        };
        tab("Controls", [this] { m_controls.draw(m_model); });
        tab("Points", [this, &frame] { m_samples.draw(m_model, frame); });
        tab("Test", [this] { m_test.draw(m_model); });
        ImGui::EndTabBar();
    }

    ViewModel &m_model;
    ControlsPanel m_controls;
    SamplesPanel m_samples;
    TestPanel m_test;
    bool m_openHelp = false;
};

} // namespace

void showWindow(std::vector<Subject> subjects, Actions actions, const Settings &settings,
                const WindowOptions &options) {
    ViewModel model(std::move(subjects), std::move(actions), settings, window::wakeWindow);
    WarpWindow contents(model, options);
    window::Options frame;
    frame.title = "warptest";
    frame.scale = options.scale;
    frame.theme = options.theme;
    if (options.runAtStart) {
        model.runOne();
    }
    if (!options.screenshot.empty()) {
        window::drawToFile(frame, contents, options.screenshot, options.textFile);
    } else {
        window::runWindow(frame, contents);
    }
}

} // namespace viewer
