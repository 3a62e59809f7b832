// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <utility>
#include <vector>

#include <imgui/imgui.h>
#include <preview/image_panel.h>
#include <preview/show.h>
#include <preview/side_panel.h>
#include <window/key_help.h>
#include <window/ui.h>

namespace preview {

namespace {

constexpr float kSideWidth = 310; ///< at scale 1
constexpr float kNarrow = 760;    ///< below this the numbers stand under the image
constexpr float kSideHeight = 0.42f;
constexpr double kExposureStep = 0.5;
constexpr double kZoomStep = 1.5;
constexpr double kSplitStep = 0.02;
constexpr int kFarStep = 16;
constexpr double kRefresh = 0.25; ///< cores are for rendering [s]

constexpr const char *kViews[] = {"Image  (1)", "Reference  (2)", "Split  (3)", "Difference  (4)"};

const std::vector<window::KeyHelp> kHelp = {
    {"1, 2, 3, 4", "image, reference, split, difference"},
    {"Shift", "hold to see the reference"},
    {", .", "move the split line"},
    {"E, Shift+E", "exposure up, down"},
    {"N", "the brightest hundredth becomes white"},
    {"+, -", "zoom (also the wheel)"},
    {"F, 0, R", "fit, pixel by pixel, reset"},
    {"Arrow keys", "walk over the pixels, with Ctrl 16 at once"},
    {"C", "copy the values"},
    {"I, J", "mark pixels that are not a number, infinite or negative; go to the next one"},
    {"Space", "pause and go on"},
    {"Ctrl+S", "stop and save what is there"},
    {"B", "outlines of blocks in work"},
    {"T", "theme: dark, light, high contrast"},
    {"Ctrl +, Ctrl -", "size of everything"},
    {"Q", "close: the render goes on in the terminal"},
    {"", "An .exr dropped on the window is the reference. Far in, pixels show their values."}};

class PreviewWindow : public window::Ui {
public:
    explicit PreviewWindow(ViewModel &model) : m_model(model) {}

    void draw(const window::Frame &frame) override {
        RenderJob *const job = m_model.job();
        if (job != nullptr && !job->isStarted())
            job->start(window::wakeWindow);
        if (job != nullptr && job->isInterrupted())
            frame.requests->close = true;
        m_model.refresh();
        // Every button has a key of its own; arrow keys walk over pixels.
        ImGui::GetIO().ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
        handleKeys(frame);
        ImGui::SetNextWindowPos(ImVec2(0, 0));
        ImGui::SetNextWindowSize(ImVec2(frame.width, frame.height));
        ImGui::Begin("nori", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoSavedSettings);
        drawToolbar();
        const ImGuiStyle &style = ImGui::GetStyle();
        const float status = 2 * ImGui::GetTextLineHeightWithSpacing() + style.ItemSpacing.y;
        drawPanels(frame, status);
        ImGui::Separator();
        ImGui::PushTextWrapPos(ImGui::GetWindowWidth() - 5 * ImGui::GetFontSize());
        ImGui::TextUnformatted(m_model.statusLine().c_str());
        ImGui::PopTextWrapPos();
        const char *const hint = "? help";
        ImGui::SetCursorPos(
            ImVec2(ImGui::GetWindowWidth() - ImGui::CalcTextSize(hint).x - style.WindowPadding.x,
                   ImGui::GetWindowHeight() - ImGui::GetTextLineHeight() - style.WindowPadding.y));
        ImGui::TextDisabled("%s", hint);
        ImGui::End();
        window::drawKeyHelp(m_openHelp, kHelp);
    }

    bool isBusy() const override {
        const RenderJob *const job = m_model.job();
        return job != nullptr && !job->isPaused() && job->progress().phase != Phase::Finished;
    }

    double busyInterval() const override { return kRefresh; }

    void onShortcut(char letter) override {
        if (letter == 's')
            stop();
    }

    void onFileDropped(const std::string &file) override { m_model.loadReference(file); }

    void releaseGraphics() override { m_image.release(); }

private:
    void handleKeys(const window::Frame &frame) {
        const ImGuiIO &io = ImGui::GetIO();
        m_model.holdReference(io.KeyShift && !io.WantTextInput && m_model.hasReference());
        if (io.WantTextInput)
            return;
        const int step = io.KeyCtrl ? kFarStep : 1;
        const std::pair<ImGuiKey_, nori::Point2i> arrows[] = {{ImGuiKey_LeftArrow, {-step, 0}},
                                                              {ImGuiKey_RightArrow, {step, 0}},
                                                              {ImGuiKey_UpArrow, {0, -step}},
                                                              {ImGuiKey_DownArrow, {0, step}}};
        for (const auto &[key, move] : arrows) {
            if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)))
                m_model.moveCursor(move.x(), move.y());
        }
        if (io.KeyCtrl || io.KeyAlt)
            return;
        for (const ImWchar key : io.InputQueueCharacters) {
            if (!pressView(static_cast<char>(key < 128 ? key : 0)))
                press(static_cast<char>(key < 128 ? key : 0), frame);
        }
    }

    /// Keys that change how the image is shown.
    bool pressView(char key) {
        Look look = m_model.look();
        switch (key) {
        case '1':
        case '2':
        case '3':
        case '4':
            look.view = static_cast<View>(key - '1');
            break;
        case 'e':
            look.exposure += kExposureStep;
            break;
        case 'E':
            look.exposure -= kExposureStep;
            break;
        case 'i':
            look.markFaulty = !look.markFaulty;
            break;
        case ',':
            look.split -= kSplitStep;
            break;
        case '.':
            look.split += kSplitStep;
            break;
        default:
            return false;
        }
        m_model.setLook(look);
        return true;
    }

    void press(char key, const window::Frame &frame) {
        const double x = m_model.cursorInArea()[0];
        const double y = m_model.cursorInArea()[1];
        switch (key) {
        case '+':
            m_model.zoomBy(kZoomStep, x, y);
            break;
        case '-':
            m_model.zoomBy(1 / kZoomStep, x, y);
            break;
        case '0':
            m_model.zoomBy(1 / m_model.zoom(), x, y);
            break;
        case 'f':
            m_model.fit();
            break;
        case 'n':
            m_model.normalize();
            break;
        case 'r':
            m_model.reset();
            break;
        case 'j':
            m_model.findFaulty();
            break;
        case 'c':
            ImGui::SetClipboardText(m_model.pixelText().c_str());
            break;
        case 'b':
            m_image.showBlocks(!m_image.showsBlocks());
            break;
        case ' ':
            if (m_model.job() != nullptr)
                m_model.job()->setPaused(!m_model.job()->isPaused());
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

    void stop() {
        if (m_model.job() != nullptr && m_model.job()->progress().phase != Phase::Finished)
            m_model.job()->stop();
    }

    void drawToolbar() {
        Look look = m_model.look();
        RenderJob *const job = m_model.job();
        if (job != nullptr && job->progress().phase != Phase::Finished) {
            if (ImGui::Button(job->isPaused() ? "Go on  (Space)" : "Pause  (Space)"))
                job->setPaused(!job->isPaused());
            ImGui::SameLine();
            if (ImGui::Button("Stop and save  (Ctrl+S)"))
                stop();
            follow(12);
        }
        auto exposure = static_cast<float>(look.exposure);
        ImGui::SetNextItemWidth(9 * ImGui::GetFontSize());
        if (ImGui::SliderFloat("EV  (E)", &exposure, -10, 10, "%+.1f"))
            look.exposure = static_cast<double>(exposure);
        follow(9);
        ImGui::SetNextItemWidth(9 * ImGui::GetFontSize());
        int view = static_cast<int>(m_model.hasReference() ? look.view : View::Image);
        if (ImGui::Combo("##view", &view, kViews, m_model.hasReference() ? 4 : 1))
            look.view = static_cast<View>(view);
        follow(4);
        if (ImGui::Button("Fit  (F)"))
            m_model.fit();
        follow(4);
        if (ImGui::Button("1:1  (0)"))
            m_model.zoomBy(1 / m_model.zoom(), m_model.cursorInArea()[0],
                           m_model.cursorInArea()[1]);
        follow(9);
        ImGui::Checkbox("Mark NaN  (I)", &look.markFaulty);
        if (job != nullptr && job->progress().phase != Phase::Finished) {
            follow(7);
            bool blocks = m_image.showsBlocks();
            if (ImGui::Checkbox("Blocks  (B)", &blocks))
                m_image.showBlocks(blocks);
        }
        m_model.setLook(look);
    }

    /// The next item stands on the same line if there is room for so many heights of the font.
    static void follow(float width) {
        const float right = ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x;
        if (right + width * ImGui::GetFontSize() < ImGui::GetWindowWidth())
            ImGui::SameLine();
    }

    void drawPanels(const window::Frame &frame, float status) {
        const bool isNarrow = frame.width < kNarrow * frame.scale;
        const ImVec2 all = ImGui::GetContentRegionAvail();
        const ImGuiStyle &style = ImGui::GetStyle();
        const ImVec2 image =
            isNarrow ? ImVec2(0, (all.y - status) * (1 - kSideHeight))
                     : ImVec2(all.x - kSideWidth * frame.scale - style.ItemSpacing.x, -status);
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(1, 1));
        ImGui::BeginChild("image", image, true,
                          ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
        ImGui::PopStyleVar();
        m_image.draw(m_model, frame.scale);
        ImGui::EndChild();
        if (!isNarrow)
            ImGui::SameLine();
        ImGui::BeginChild("numbers", ImVec2(0, -status), true);
        drawSidePanel(m_model, frame.scale);
        ImGui::EndChild();
    }

    ViewModel &m_model;
    ImagePanel m_image;
    bool m_openHelp = false;
};

} // namespace

bool canShow() {
    return window::hasDisplay();
}

void show(ViewModel &model, const WindowOptions &options) {
    PreviewWindow contents(model);
    window::Options frame;
    frame.title = "nori: " + model.title();
    frame.scale = options.scale;
    frame.theme = window::themeByName(options.theme);
    try {
        if (options.screenshot.empty())
            window::runWindow(frame, contents);
        else
            window::drawToFile(frame, contents, options.screenshot, options.textFile);
    } catch (const window::NoWindow &error) {
        throw CannotShow(std::string(error.what()) +
                         ". Without --window nori works in the terminal alone; "
                         "--screenshot FILE.png needs no display");
    }
}

} // namespace preview
