// SPDX-License-Identifier: MIT
#pragma once

#include <grader/app/command_line.h>

#include <CLI/CLI.hpp>

#include <string>

namespace grader {

constexpr int kMostJobs = 256;

/// `en`, `es`, or `auto`: what the locale says, English if it says anything but Spanish.
Language languageOf(const std::string &code);

const CLI::App *addCalibrate(CLI::App &program, CalibrateCommand &command);

} // namespace grader
