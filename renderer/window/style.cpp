// SPDX-License-Identifier: MIT
#include <filesystem>
#include <utility>

#include <window/style.h>

namespace window {

namespace {

/// Where Debian (fonts-dejavu-core), Fedora and Arch keep it.
constexpr const char *kFonts[] = {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                                  "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
                                  "/usr/share/fonts/TTF/DejaVuSans.ttf"};

/// Latin with accents, Greek, super- and subscripts, arrows, mathematics, signs of the verdicts.
constexpr ImWchar kGlyphs[] = {0x20,   0x17f,  0x300,  0x3ff,  0x2010, 0x2044, 0x2070,
                               0x209c, 0x2190, 0x21ff, 0x2200, 0x22ff, 0x25a0, 0x25ff,
                               0x2600, 0x260f, 0x2700, 0x2720, 0};

constexpr float kFontSize = 15.0f;

ImVec4 rgb(unsigned hex) {
    const auto channel = [hex](unsigned shift) {
        return static_cast<float>((hex >> shift) & 0xffU) / 255.0f;
    };
    return {channel(16U), channel(8U), channel(0U), 1.0f};
}

/// Told apart with any colour vision: the smallest distance of two statuses is 24 (CIEDE2000).
Palette makePalette(Theme theme) {
    if (theme == Theme::Light)
        return {rgb(0x0072b2), rgb(0xb34700), rgb(0x7a5200), rgb(0x6b7280),
                rgb(0x0072b2), rgb(0x202428), rgb(0xffffff)};
    if (theme == Theme::HighContrast)
        return {rgb(0x7fd0ff), rgb(0xffa260), rgb(0xffff66), rgb(0xd0d0d0),
                rgb(0xffff00), rgb(0xffffff), rgb(0x000000)};
    return {rgb(0x56b4e9), rgb(0xff8a3d), rgb(0xf0e442), rgb(0x9ca3af),
            rgb(0x56b4e9), rgb(0xe6e8ea), rgb(0x101418)};
}

Palette &current() {
    static Palette colors = makePalette(Theme::Dark);
    return colors;
}

void setColors(Theme theme, ImGuiStyle &style) {
    if (theme == Theme::Light) {
        ImGui::StyleColorsLight(&style);
        style.Colors[ImGuiCol_TextDisabled] = rgb(0x5b6470);
        style.Colors[ImGuiCol_Border] = rgb(0xb6bcc4);
        style.Colors[ImGuiCol_ChildBg] = rgb(0xf6f7f8);
    } else {
        ImGui::StyleColorsDark(&style);
        style.Colors[ImGuiCol_TextDisabled] = rgb(0x9ca3af);
        style.Colors[ImGuiCol_Border] = rgb(0x4b5563);
    }
    style.Colors[ImGuiCol_PopupBg].w = 1.0f; // nothing shines through a list
    if (theme == Theme::HighContrast) {
        for (const ImGuiCol color : {ImGuiCol_WindowBg, ImGuiCol_ChildBg, ImGuiCol_PopupBg})
            style.Colors[color] = rgb(0x000000);
        style.Colors[ImGuiCol_Text] = rgb(0xffffff);
        style.Colors[ImGuiCol_TextDisabled] = rgb(0xd0d0d0);
        style.Colors[ImGuiCol_Border] = rgb(0xffffff);
        style.Colors[ImGuiCol_FrameBg] = rgb(0x303030);
    }
    style.Colors[ImGuiCol_NavHighlight] = makePalette(theme).check;
    style.Colors[ImGuiCol_PlotHistogram] = makePalette(theme).accent;
}

} // namespace

Theme themeByName(const std::string &name) {
    const std::pair<const char *, Theme> themes[] = {
        {"dark", Theme::Dark}, {"light", Theme::Light}, {"contrast", Theme::HighContrast}};
    for (const auto &theme : themes) {
        if (name == theme.first)
            return theme.second;
    }
    throw std::invalid_argument(name + ": no such theme; there are dark, light and contrast");
}

const Palette &palette() {
    return current();
}

ImFont *addFont(ImFontAtlas &fonts, float scale, int oversampling) {
    ImFontConfig config;
    config.SizePixels = kFontSize * scale;
    config.OversampleH = oversampling;
    config.PixelSnapH = oversampling == 1;
    for (const char *file : kFonts) {
        if (!std::filesystem::exists(file))
            continue;
        ImFont *const font = fonts.AddFontFromFileTTF(file, kFontSize * scale, &config, kGlyphs);
        if (font != nullptr)
            return font;
    }
    return fonts.AddFontDefault(&config);
}

void setStyle(Theme theme, float scale) {
    current() = makePalette(theme);
    ImGuiStyle &style = ImGui::GetStyle();
    style = ImGuiStyle();
    style.FrameRounding = 3.0f;
    style.GrabRounding = 3.0f;
    style.WindowRounding = 0.0f;
    style.ChildBorderSize = 1.0f;
    style.FrameBorderSize = theme == Theme::Dark ? 0.0f : 1.0f;
    style.ScaleAllSizes(scale);
    setColors(theme, style);

    ImFontAtlas &fonts = *ImGui::GetIO().Fonts;
    fonts.Clear();
    addFont(fonts, scale, 2);
}

} // namespace window
