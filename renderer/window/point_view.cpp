// SPDX-License-Identifier: MIT
#include <cstddef>
#include <string>

#include <window/opengl.h>
#include <window/point_view.h>
#include <window/texture.h>
#include <window/ui.h>

namespace window {

namespace {

constexpr char kVertexShader[] = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 color;
uniform mat4 transform;
uniform float pointSize;
out vec4 shade;
void main() {
    gl_Position = transform * vec4(position, 1.0);
    gl_PointSize = pointSize;
    shade = color;
})";

constexpr char kFragmentShader[] = R"(#version 330 core
in vec4 shade;
out vec4 color;
void main() { color = shade; })";

/// OpenGL takes an offset as a pointer from address 0.
// NOLINTNEXTLINE(performance-no-int-to-ptr): that is its interface
const void *const kColorOffset = reinterpret_cast<const void *>(offsetof(Vertex, color));

unsigned compile(GLenum kind, const char *source) {
    const unsigned shader = glCreateShader(kind);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint good = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (good == 0) {
        std::array<char, 512> log{};
        glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
        throw NoWindow(std::string("OpenGL does not take our shader: ") + log.data());
    }
    return shader;
}

bool isSame(const ImVec4 &a, const ImVec4 &b) {
    return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w;
}

} // namespace

PointView::~PointView() {
    release();
}

void PointView::setPoints(const std::vector<Vertex> &points) {
    upload(m_points, points);
}

void PointView::setLines(const std::vector<Vertex> &lines) {
    upload(m_lines, lines);
}

void PointView::upload(Batch &batch, const std::vector<Vertex> &vertices) {
    if (batch.array == 0) {
        glGenVertexArrays(1, &batch.array);
        glGenBuffers(1, &batch.buffer);
        glBindVertexArray(batch.array);
        glBindBuffer(GL_ARRAY_BUFFER, batch.buffer);
        glEnableVertexAttribArray(0);
        glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), nullptr);
        glEnableVertexAttribArray(1);
        glVertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(Vertex), kColorOffset);
        glBindVertexArray(0);
    }
    glBindBuffer(GL_ARRAY_BUFFER, batch.buffer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)),
                 vertices.data(), GL_DYNAMIC_DRAW);
    batch.count = static_cast<int>(vertices.size());
    m_changed = true;
}

void PointView::createProgram() {
    m_program = glCreateProgram();
    const unsigned shaders[] = {compile(GL_VERTEX_SHADER, kVertexShader),
                                compile(GL_FRAGMENT_SHADER, kFragmentShader)};
    for (const unsigned shader : shaders)
        glAttachShader(m_program, shader);
    glLinkProgram(m_program);
    for (const unsigned shader : shaders)
        glDeleteShader(shader);
    m_transformLocation = glGetUniformLocation(m_program, "transform");
    m_sizeLocation = glGetUniformLocation(m_program, "pointSize");
}

void PointView::resize(int width, int height) {
    if (m_framebuffer == 0) {
        glGenFramebuffers(1, &m_framebuffer);
        glGenTextures(1, &m_color);
        glGenRenderbuffers(1, &m_depth);
    }
    m_width = width;
    m_height = height;
    glBindTexture(GL_TEXTURE_2D, m_color);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glBindRenderbuffer(GL_RENDERBUFFER, m_depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_color, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, m_depth);
}

ImTextureID PointView::draw(int width, int height, const Matrix &transform, float pointSize,
                            const ImVec4 &background) {
    if (!m_changed && width == m_width && height == m_height && transform == m_transform &&
        pointSize == m_pointSize && isSame(background, m_background))
        return textureId(m_color);
    GLint previous = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &previous);
    if (m_program == 0)
        createProgram();
    if (width != m_width || height != m_height)
        resize(width, height);
    m_changed = false;
    m_transform = transform;
    m_pointSize = pointSize;
    m_background = background;

    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    glViewport(0, 0, width, height);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(background.x, background.y, background.z, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_PROGRAM_POINT_SIZE);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE);
    glUseProgram(m_program);
    glUniformMatrix4fv(m_transformLocation, 1, GL_FALSE, transform.data());
    glUniform1f(m_sizeLocation, pointSize);
    glBindVertexArray(m_lines.array);
    glDrawArrays(GL_LINES, 0, m_lines.count);
    glBindVertexArray(m_points.array);
    glDrawArrays(GL_POINTS, 0, m_points.count);
    glBindVertexArray(0);
    glDisable(GL_DEPTH_TEST);
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<unsigned>(previous));
    return textureId(m_color);
}

void PointView::release() {
    for (Batch *batch : {&m_points, &m_lines}) {
        if (batch->array != 0) {
            glDeleteVertexArrays(1, &batch->array);
            glDeleteBuffers(1, &batch->buffer);
        }
        *batch = Batch();
    }
    if (m_program != 0)
        glDeleteProgram(m_program);
    if (m_framebuffer != 0) {
        glDeleteFramebuffers(1, &m_framebuffer);
        glDeleteTextures(1, &m_color);
        glDeleteRenderbuffers(1, &m_depth);
    }
    m_program = m_framebuffer = m_color = m_depth = 0;
    m_width = m_height = 0;
    m_changed = true;
}

} // namespace window
