// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>

namespace grader {

/// Turns SIGINT and SIGTERM into a flag: the first one asks for a clean end, a second one ends the
/// program at once.
/// \return  the flag; lives as long as the program
const std::atomic<bool> &catchInterrupts();

} // namespace grader
