// SPDX-License-Identifier: MIT
#pragma once

#include <grader/images/comparison.h>

#include <string>

namespace grader {

/// PNG file of a comparison's tiles, the channels R, G, B side by side: blue where the image is
/// darker than the reference, red where it is brighter, white where z is 0 and full at |z| >= 6;
/// dark outlines around tiles beyond the skewness gate. Pixels are those of the image. Below is the
/// scale from z = -6 to 6.
/// \throws GraderError  if there are no tiles
std::string tileMapPng(const Comparison &comparison);

} // namespace grader
