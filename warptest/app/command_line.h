// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <viewer/settings.h>

/// How `--dump` writes numbers.
enum class DumpFormat { None, Matlab, Csv, Json };

/// What `warptest` was asked to do.
struct CommandLine {
    std::string warp; ///< id of the catalogue; empty: none was named
    viewer::Settings settings;
    std::string against; ///< whose warps; empty: the renderer's
    bool window = false; ///< also with a warp
    bool all = false;
    bool json = false;
    DumpFormat dump = DumpFormat::None;
    bool mistakes = false;  ///< known wrong warps join the list
    bool run = false;       ///< the window starts with a test
    std::string evidence;   ///< folder for the handout's pictures; empty: none
    std::string html;       ///< page of the tests; empty: none
    std::string screenshot; ///< PNG of the window, drawn without a display
    std::string textFile;   ///< texts of the window
    std::string theme = "dark";
    double scale = 0.0;
    int tab = 0;
    std::string text; ///< the command itself, for the page
};

/// \return  nothing when the program is done already (help, a mistake): `exitCode` is set
std::optional<CommandLine> parseCommandLine(int argc, char **argv, int &exitCode);
