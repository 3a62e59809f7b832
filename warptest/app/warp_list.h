// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <viewer/subject.h>

/// The warps of <nori/warp.h>, in the catalogue's order.
std::vector<viewer::Subject> rendererWarps();

/// Those of a hand-in (archive or folder) or of one C++ file, built and called in the sandbox; says
/// on standard error how far the building is, and what was built around.
/// \throws std::runtime_error  if it cannot be read or built, with the compiler's messages
std::vector<viewer::Subject> submittedWarps(const std::string &path);

/// Known wrong warps and densities, each with the right other half, and one
/// that throws, as the course hands it out.
std::vector<viewer::Subject> mistakenWarps();
