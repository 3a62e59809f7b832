// SPDX-License-Identifier: MIT
#include <png.h>

#include <chrono>
#include <cstdint>
#include <thread>
#include <vector>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <imgui/imgui.h>
#include <window/frames.h>
#include <window/opengl.h>
#include <window/ui.h>

namespace window {

namespace {

/// ImGui needs some frames to know the sizes of its windows.
constexpr int kSettlingFrames = 4;
constexpr std::chrono::milliseconds kBusyInterval{20};

/// An OpenGL context without any surface but a buffer of its own: no display is asked.
class Offscreen {
public:
    Offscreen(int width, int height) {
        const auto getDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
            eglGetProcAddress("eglGetPlatformDisplayEXT"));
        m_display = getDisplay == nullptr
                        ? EGL_NO_DISPLAY
                        : getDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (m_display == EGL_NO_DISPLAY || eglInitialize(m_display, nullptr, nullptr) == EGL_FALSE)
            throw NoWindow("EGL cannot draw without a display; install libegl-mesa0 and "
                           "libgl1-mesa-dri, or use the command line alone");
        eglBindAPI(EGL_OPENGL_API);
        const EGLint configWishes[] = {EGL_SURFACE_TYPE,
                                       EGL_PBUFFER_BIT,
                                       EGL_RENDERABLE_TYPE,
                                       EGL_OPENGL_BIT,
                                       EGL_RED_SIZE,
                                       8,
                                       EGL_GREEN_SIZE,
                                       8,
                                       EGL_BLUE_SIZE,
                                       8,
                                       EGL_ALPHA_SIZE,
                                       8,
                                       EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        eglChooseConfig(m_display, configWishes, &config, 1, &count);
        const EGLint contextWishes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                        3,
                                        EGL_CONTEXT_MINOR_VERSION,
                                        3,
                                        EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                        EGL_NONE};
        const EGLint surfaceWishes[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
        if (count > 0) {
            m_context = eglCreateContext(m_display, config, EGL_NO_CONTEXT, contextWishes);
            m_surface = eglCreatePbufferSurface(m_display, config, surfaceWishes);
        }
        if (count == 0 || eglMakeCurrent(m_display, m_surface, m_surface, m_context) == EGL_FALSE) {
            eglTerminate(m_display);
            throw NoWindow("EGL offers no OpenGL 3.3; install libgl1-mesa-dri, or use the command "
                           "line alone");
        }
    }

    ~Offscreen() {
        eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroySurface(m_display, m_surface);
        eglDestroyContext(m_display, m_context);
        eglTerminate(m_display);
    }

    Offscreen(const Offscreen &) = delete;
    Offscreen &operator=(const Offscreen &) = delete;

private:
    EGLDisplay m_display = EGL_NO_DISPLAY;
    EGLContext m_context = EGL_NO_CONTEXT;
    EGLSurface m_surface = EGL_NO_SURFACE;
};

void writePng(const std::string &file, int width, int height) {
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(width) *
                                     static_cast<std::size_t>(height) * 3);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(width);
    image.height = static_cast<png_uint_32>(height);
    image.format = PNG_FORMAT_RGB;
    // OpenGL's rows begin at the bottom
    if (png_image_write_to_file(&image, file.c_str(), 0, pixels.data(), -3 * width, nullptr) == 0)
        throw std::runtime_error(file + ": cannot be written: " + image.message);
}

} // namespace

void drawToFile(const Options &options, Ui &ui, const std::string &pngFile,
                const std::string &textFile) {
    const double scale = options.scale > 0 ? options.scale : 1.0;
    const auto width = static_cast<int>(options.width * scale);
    const auto height = static_cast<int>(options.height * scale);
    const Offscreen context(width, height);
    Frames frames(ui, options.theme, scale);
    ImGuiIO &io = ImGui::GetIO();
    io.DisplaySize = ImVec2(static_cast<float>(width), static_cast<float>(height));
    io.DeltaTime = 1.0f / 60.0f;
    for (int settling = kSettlingFrames; settling > 0;) {
        frames.draw(width, height);
        if (ui.isBusy()) {
            std::this_thread::sleep_for(kBusyInterval);
            settling = kSettlingFrames;
        } else {
            --settling;
        }
    }
    frames.draw(width, height, textFile);
    if (!pngFile.empty())
        writePng(pngFile, width, height);
}

} // namespace window
