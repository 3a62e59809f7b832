// SPDX-License-Identifier: MIT
#include <algorithm>

#include <imgui/backends/imgui_impl_opengl3.h>
#include <imgui/imgui.h>
#include <window/frames.h>
#include <window/opengl.h>
#include <window/style.h>

namespace window {

namespace {

constexpr double kMinScale = 0.75;
constexpr double kMaxScale = 2.5;

} // namespace

Frames::Frames(Ui &ui, Theme theme, double scale) : m_ui(ui) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO &io = ImGui::GetIO();
    io.IniFilename = nullptr; // leaves no file behind
    io.LogFilename = nullptr;
    io.ConfigInputTextCursorBlink = false; // an idle window draws nothing
    ImGui_ImplOpenGL3_Init("#version 330 core");
    m_frame.theme = theme;
    m_frame.scale = static_cast<float>(std::clamp(scale, kMinScale, kMaxScale));
    restyle();
}

Frames::~Frames() {
    m_ui.releaseGraphics();
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext();
}

void Frames::restyle() {
    setStyle(m_frame.theme, m_frame.scale);
    if (m_fontsReady) {
        ImGui_ImplOpenGL3_DestroyFontsTexture();
        ImGui_ImplOpenGL3_CreateFontsTexture();
    }
    m_fontsReady = true;
}

void Frames::changeScale(double factor) {
    m_frame.scale = static_cast<float>(
        std::clamp(static_cast<double>(m_frame.scale) * factor, kMinScale, kMaxScale));
    restyle();
}

bool Frames::draw(int width, int height, const std::string &textFile) {
    Requests requests;
    m_frame.width = static_cast<float>(width);
    m_frame.height = static_cast<float>(height);
    m_frame.requests = &requests;
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    if (!textFile.empty())
        ImGui::LogToFile(0, textFile.c_str());
    m_ui.draw(m_frame);
    if (!textFile.empty())
        ImGui::LogFinish();
    ImGui::Render();
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    m_frame.requests = nullptr;

    glViewport(0, 0, width, height);
    const ImVec4 &paper = palette().paper;
    glClearColor(paper.x, paper.y, paper.z, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    if (requests.setTheme) {
        m_frame.theme = requests.theme;
        restyle();
    }
    return !requests.close;
}

} // namespace window
