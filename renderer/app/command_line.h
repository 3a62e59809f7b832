// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

/// What `nori` was asked to do.
struct CommandLine {
    std::string scene;
    std::string output; ///< path without suffix; empty: beside the scene
    int width = 0;      ///< 0: the scene's, and so is the height
    int height = 0;
    std::string integrator; ///< empty: the scene's
    int samplesPerPixel = 0;
    std::optional<int> seed;
    int threads = 0;
    bool moments = false;
    bool quiet = false;
};

/// \return  nothing when the program is done already (help, version, a mistake): `exitCode` is set
std::optional<CommandLine> parseCommandLine(int argc, char **argv, int &exitCode);
