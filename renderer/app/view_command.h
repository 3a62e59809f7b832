// SPDX-License-Identifier: MIT
#pragma once

#include "command_line.h"

/// Whether a window is to open: asked for, or possible and nothing speaks against it.
bool opensWindow(const CommandLine &line);

/// Shows an image in a window, or prints its numbers.
/// \return  exit code
/// \throws std::exception  as renderScene()
int viewImage(const CommandLine &line);
