// SPDX-License-Identifier: MIT
#include <window/opengl.h>
#include <window/texture.h>

namespace window {

Texture::~Texture() {
    release();
}

void Texture::upload(int width, int height, const std::vector<std::uint32_t> &pixels) {
    if (m_name == 0)
        glGenTextures(1, &m_name);
    m_width = width;
    m_height = height;
    glBindTexture(GL_TEXTURE_2D, m_name);
    // cells and pixels are looked at one by one
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 pixels.data());
}

void Texture::release() {
    if (m_name != 0)
        glDeleteTextures(1, &m_name);
    m_name = 0;
}

} // namespace window
