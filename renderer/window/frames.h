// SPDX-License-Identifier: MIT
#pragma once

#include <window/ui.h>

namespace window {

/// ImGui's context and OpenGL back-end around a Ui, whatever the surface is. The OpenGL context
/// must be current all the time.
class Frames {
public:
    /// \param scale  in [kMinScale, kMaxScale]; others are clamped
    Frames(Ui &ui, Theme theme, double scale);
    ~Frames();
    Frames(const Frames &) = delete;
    Frames &operator=(const Frames &) = delete;
    Frames(Frames &&) = delete;
    Frames &operator=(Frames &&) = delete;

    /// Draws one frame into the current framebuffer.
    /// \param textFile  if not empty: gets the frame's texts
    /// \return  false if the contents ask to be closed
    bool draw(int width, int height, const std::string &textFile = {});

    /// Makes text and spaces larger or smaller, from the next frame on.
    void changeScale(double factor);

private:
    void restyle();

    Ui &m_ui;
    Frame m_frame;
    bool m_fontsReady = false;
};

} // namespace window
