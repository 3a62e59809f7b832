// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace window {

enum class Theme { Dark, Light, HighContrast };

/// The theme with this name: "dark", "light" or "contrast".
/// \throws std::invalid_argument  that names the known ones
Theme themeByName(const std::string &name);

struct Options {
    std::string title;
    int width = 1280; ///< of the contents [pixels], at scale 1
    int height = 800;
    double scale = 0; ///< of text and spaces, 0.75 to 2.5; 0: as the display says
    Theme theme = Theme::Dark;
};

/// What a key or a widget may ask of the frame around it.
struct Requests {
    bool close = false;
    bool setTheme = false;
    Theme theme = Theme::Dark;
};

/// What the frame tells the contents.
struct Frame {
    float width = 0; ///< [pixels]
    float height = 0;
    float scale = 1; ///< of text and spaces
    Theme theme = Theme::Dark;
    Requests *requests = nullptr; ///< never null while drawing
};

/// The contents of a window, drawn anew with Dear ImGui whenever something has happened.
class Ui {
public:
    virtual ~Ui() = default;
    /// Called between ImGui's NewFrame and Render, with the OpenGL context current.
    virtual void draw(const Frame &frame) = 0;

    /// Something moves by itself: frames follow each other without events.
    virtual bool isBusy() const { return false; }

    /// Between the frames of what moves by itself [s].
    virtual double busyInterval() const { return 0.05; }

    /// Ctrl and a letter (a small one) were pressed, however shortly.
    virtual void onShortcut(char) {}

    /// Files were dropped onto the window, or the user closed it.
    virtual void onFileDropped(const std::string &) {}

    /// The context goes away after this: free what holds textures.
    virtual void releaseGraphics() {}
};

/// There is no display, or no OpenGL 3.3: what() is one sentence that helps.
class NoWindow : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Whether a display is named in the environment (DISPLAY, WAYLAND_DISPLAY).
bool hasDisplay();

/// Opens a window and returns when the user has closed it. Waits for events between the frames.
/// \throws NoWindow
void runWindow(const Options &options, Ui &ui);

/// Makes runWindow() draw a frame. From any thread, and without effect when there is no window.
void wakeWindow();

/// Draws into a file, without a display: frames until the contents are no longer busy.
/// \param textFile  if not empty: the texts of the last frame, as they are read from the top
/// \throws NoWindow  std::runtime_error if a file cannot be written
void drawToFile(const Options &options, Ui &ui, const std::string &pngFile,
                const std::string &textFile);

} // namespace window
