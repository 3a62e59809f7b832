// SPDX-License-Identifier: MIT
#pragma once

// OpenGL through libOpenGL, whose functions serve any current context, GLX's or EGL's: no loader.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
