// SPDX-License-Identifier: MIT
#pragma once

namespace grader {

/// Starts, once per process, a process of ours that outlives us for two seconds if we are killed,
/// and ends the boxes that were just starting and could not die with us; see orphans.h. An end of
/// this program that runs its exit handlers ends the guard at once.
/// Without it (the machine has too many processes) the next grader that starts does the same.
void keepGuard();

} // namespace grader
