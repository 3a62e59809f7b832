// SPDX-License-Identifier: MIT
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include <GLFW/glfw3.h>
#include <imgui/backends/imgui_impl_glfw.h>
#include <imgui/imgui.h>
#include <window/frames.h>
#include <window/ui.h>

namespace window {

namespace {

/// ImGui settles (hovering, keyboard focus, sizes of windows) within so many frames of an event.
constexpr int kSettlingFrames = 3;
constexpr double kScaleStep = 1.125; ///< of Ctrl + and Ctrl -

std::atomic<bool> &isOpen() {
    static std::atomic<bool> open{false};
    return open;
}

/// By the characters on the keys, which are elsewhere on other keyboards than the American one.
char characterOf(int key, int scancode) {
    const char *const name = glfwGetKeyName(key, scancode);
    return name == nullptr ? '\0' : *name;
}

/// GLFW and its window, undone in the right order.
class Display {
public:
    explicit Display(const Options &options, Ui &ui) : m_ui(ui) {
        if (!hasDisplay())
            throw NoWindow("there is no display (DISPLAY is not set)");
        if (glfwInit() == GLFW_FALSE)
            throw NoWindow("the display cannot be opened: " + lastError());
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
        m_window = glfwCreateWindow(options.width, options.height, options.title.c_str(), nullptr,
                                    nullptr);
        if (m_window == nullptr) {
            const std::string reason = lastError();
            glfwTerminate();
            throw NoWindow("the display offers no OpenGL 3.3: " + reason);
        }
        glfwMakeContextCurrent(m_window);
        glfwSwapInterval(1);
        glfwSetWindowUserPointer(m_window, this);
        glfwSetDropCallback(m_window, [](GLFWwindow *window, int count, const char **files) {
            auto *const display = static_cast<Display *>(glfwGetWindowUserPointer(window));
            for (int i = 0; i < count; ++i)
                display->m_ui.onFileDropped(files[i]);
        });
        glfwSetKeyCallback( // ImGui's back-end calls it before its own
            m_window, [](GLFWwindow *window, int key, int scancode, int action, int modifiers) {
                auto *const display = static_cast<Display *>(glfwGetWindowUserPointer(window));
                display->note(key, action);
                if (action != GLFW_RELEASE && (modifiers & GLFW_MOD_CONTROL) != 0)
                    display->press(characterOf(key, scancode));
            });
        isOpen() = true;
    }

    ~Display() {
        isOpen() = false;
        glfwDestroyWindow(m_window);
        glfwTerminate();
    }

    Display(const Display &) = delete;
    Display &operator=(const Display &) = delete;

    GLFWwindow *window() const { return m_window; }

    /// Presses of Ctrl + less those of Ctrl - since the last call.
    int takeScaleSteps() { return std::exchange(m_scaleSteps, 0); }

    /// Keys that went down and up since the last call: while frames take long, most of them.
    std::vector<int> takeShortKeys() {
        m_pressed.clear();
        return std::exchange(m_over, {});
    }

private:
    void note(int key, int action) {
        const auto isThis = [key](int other) {
            return other == key;
        };
        if (action == GLFW_PRESS) {
            m_pressed.push_back(key);
            m_over.erase(std::remove_if(m_over.begin(), m_over.end(), isThis), m_over.end());
        } else if (action == GLFW_RELEASE && key >= 0 &&
                   std::any_of(m_pressed.begin(), m_pressed.end(), isThis)) {
            m_over.push_back(key);
        }
    }

    /// With Ctrl held. Here and not in a frame: ImGui 1.86 misses what is over before the next one.
    void press(char key) {
        if (key == '+' || key == '=')
            ++m_scaleSteps;
        else if (key == '-')
            --m_scaleSteps;
        else if (key >= 'a' && key <= 'z')
            m_ui.onShortcut(key);
    }

    static std::string lastError() {
        const char *text = nullptr;
        glfwGetError(&text);
        return text == nullptr ? "no reason is given" : text;
    }

    Ui &m_ui;
    GLFWwindow *m_window = nullptr;
    int m_scaleSteps = 0;
    std::vector<int> m_pressed; ///< since the last frame
    std::vector<int> m_over;    ///< those of them that are up again
};

/// Holds keys down for a frame: ImGui 1.86 looks only at what is down when the frame begins.
class HeldKeys {
public:
    explicit HeldKeys(std::vector<int> keys) : m_keys(std::move(keys)) { set(true); }

    ~HeldKeys() { set(false); }

    HeldKeys(const HeldKeys &) = delete;
    HeldKeys &operator=(const HeldKeys &) = delete;

private:
    void set(bool isDown) const {
        for (const int key : m_keys)
            ImGui::GetIO().KeysDown[key] = isDown;
    }

    std::vector<int> m_keys;
};

/// The GLFW back-end of ImGui, which must end before ImGui's context.
class Input {
public:
    explicit Input(GLFWwindow *window) {
        ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
        ImGui_ImplGlfw_InitForOpenGL(window, true);
    }

    ~Input() { ImGui_ImplGlfw_Shutdown(); }

    Input(const Input &) = delete;
    Input &operator=(const Input &) = delete;
};

void waitForEvents(const Ui &ui, int &settling) {
    if (ui.isBusy()) {
        glfwWaitEventsTimeout(ui.busyInterval());
        settling = kSettlingFrames;
    } else if (settling > 0) {
        --settling;
        glfwPollEvents();
    } else {
        glfwWaitEvents();
        settling = kSettlingFrames;
    }
}

} // namespace

bool hasDisplay() {
    for (const char *name : {"DISPLAY", "WAYLAND_DISPLAY"}) {
        const char *const value = std::getenv(name);
        if (value != nullptr && *value != '\0')
            return true;
    }
    return false;
}

void wakeWindow() {
    if (isOpen())
        glfwPostEmptyEvent();
}

void runWindow(const Options &options, Ui &ui) {
    Display display(options, ui);
    GLFWwindow *const window = display.window();
    float contentScale = 1.0f;
    glfwGetWindowContentScale(window, &contentScale, nullptr);
    Frames frames(ui, options.theme,
                  options.scale > 0 ? options.scale : static_cast<double>(contentScale));
    const Input input(window);
    int settling = kSettlingFrames;
    bool open = true;
    while (open && glfwWindowShouldClose(window) == GLFW_FALSE) {
        int width = 0;
        int height = 0;
        glfwGetFramebufferSize(window, &width, &height);
        const int steps = display.takeScaleSteps();
        if (steps != 0)
            frames.changeScale(std::pow(kScaleStep, steps));
        if (width > 0 && height > 0) { // neither when it is iconified
            ImGui_ImplGlfw_NewFrame();
            const HeldKeys held(display.takeShortKeys());
            open = frames.draw(width, height);
            glfwSwapBuffers(window);
        }
        waitForEvents(ui, settling);
    }
}

} // namespace window
