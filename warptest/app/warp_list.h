// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <viewer/subject.h>

/// The warps of <nori/warp.h>, in the catalogue's order.
std::vector<viewer::Subject> rendererWarps();

/// Known wrong warps and densities, each with the right other half, and one
/// that throws, as the course hands it out.
std::vector<viewer::Subject> mistakenWarps();
