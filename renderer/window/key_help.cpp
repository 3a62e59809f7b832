// SPDX-License-Identifier: MIT
#include "key_help.h"

#include <imgui/imgui.h>

namespace window {

namespace {

bool isEscapePressed() {
    const int escape = ImGui::GetKeyIndex(ImGuiKey_Escape);
    return escape >= 0 && ImGui::IsKeyPressed(escape, false);
}

} // namespace

void drawKeyHelp(bool &open, const std::vector<KeyHelp> &lines) {
    if (open)
        ImGui::OpenPopup("Keys");
    open = false;
    if (!ImGui::BeginPopupModal("Keys", nullptr, ImGuiWindowFlags_AlwaysAutoResize))
        return;
    if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
        for (const KeyHelp &line : lines) {
            if (*line.keys == '\0')
                continue;
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(line.keys);
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(line.what);
        }
        ImGui::EndTable();
    }
    for (const KeyHelp &line : lines) {
        if (*line.keys == '\0')
            ImGui::TextUnformatted(line.what);
    }
    if (ImGui::Button("Close  (Esc)") || isEscapePressed())
        ImGui::CloseCurrentPopup();
    ImGui::SetItemDefaultFocus();
    ImGui::EndPopup();
}

} // namespace window
