// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>

#include "command_line.h"

constexpr int kInterrupted = 130;

/// Renders the scene, in a window if one is to open, and writes the image.
/// \param cancelled  stops the render and keeps what is there
/// \return  exit code
/// \throws std::exception  with a message for people; preview::CannotShow if no window can be
/// opened
int renderScene(const CommandLine &line, std::atomic<bool> &cancelled);
