// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <preview/coloring.h>
#include <preview/show.h>

/// When a window opens.
enum class Windowing { Never, IfPossible, Always };

/// What `nori` was asked to do.
struct CommandLine {
    std::string file;      ///< scene or image
    std::string reference; ///< image to compare with; empty: one that is found by name
    std::string output;    ///< path without suffix; empty: beside the scene
    int width = 0;         ///< 0: the scene's, and so is the height
    int height = 0;
    std::string integrator; ///< empty: the scene's
    int samplesPerPixel = 0;
    std::optional<int> seed;
    int threads = 0;
    bool moments = false;
    bool quiet = false;
    Windowing windowing = Windowing::IfPossible;
    preview::WindowOptions window;
    preview::Look look; ///< how the window starts
};

/// \return  nothing when the program is done already (help, version, a mistake): `exitCode` is set
std::optional<CommandLine> parseCommandLine(int argc, char **argv, int &exitCode);

/// Whether the file is an image, by its suffix; else it is taken for a scene.
bool namesImage(const std::string &file);
