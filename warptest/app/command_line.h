// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <viewer/settings.h>

/// What `warptest` was asked to do.
struct CommandLine {
    std::string warp; ///< id of the catalogue; empty: none was named
    viewer::Settings settings;
    bool window = false; ///< also with a warp
    bool all = false;
    bool json = false;
    bool mistakes = false;  ///< known wrong warps join the window's list
    bool run = false;       ///< the window starts with a test
    std::string evidence;   ///< folder for the handout's pictures; empty: none
    std::string screenshot; ///< PNG of the window, drawn without a display
    std::string textFile;   ///< texts of the window
    std::string theme = "dark";
    double scale = 0.0;
    int tab = 0;
};

/// \return  nothing when the program is done already (help, a mistake): `exitCode` is set
std::optional<CommandLine> parseCommandLine(int argc, char **argv, int &exitCode);
