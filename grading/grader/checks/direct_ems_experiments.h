// SPDX-License-Identifier: MIT
#pragma once

#include <grader/checks/check.h>
#include <grader/diagnosis/guess.h>

#include <vector>

namespace grader {

// Experiments after a failure: small scenes of one ray, each made for one mistake. Nothing is told
// if the code does not answer with numbers.

/// Puts a blocker at several parts of the way from a surface to a point light, and behind it; if
/// shadows are right, lets the light sink to the horizon.
std::vector<Guess> experimentWithOneLight(CheckContext &context);

/// Looks at a light from its front and from behind, with the world's origin on either side.
std::vector<Guess> experimentWithSides(CheckContext &context);

} // namespace grader
