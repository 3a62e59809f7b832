// SPDX-License-Identifier: MIT
#pragma once

namespace grader {

/// The host name in a box, by which its bubblewrap is known.
constexpr char kBoxHostName[] = "norigrade-box";

/// Kills the boxes of graders that were themselves killed at the wrong moment: bubblewrap's first
/// process asks to die with its parent only after it has started the program, so one whose parent
/// dies just before that lives on (its #633). Boxes of graders that run are left alone.
void killOrphans();

} // namespace grader
