// SPDX-License-Identifier: MIT
#pragma once

#include <grader/checks/answer.h>
#include <grader/checks/check.h>

#include <cstdint>

namespace grader {

/// That are asked at the same time: more than most machines have cores, so that they meet there
/// too.
constexpr std::uint32_t kThreads = 4;

/// Asks for the same on one thread and on several, and compares bit for bit. What differs on one
/// thread already is no matter of threads, and passes. Wrong code passes where threads never meet
/// in it, right code cannot fail.
///
/// \param group     two requests that differ in their number of threads; the first has one
/// \param what      the floats of the answer, in the plural
CheckResult compareThreads(CheckContext &context, protocol::RequestGroup group, const char *what,
                           const char *diagnosis);

} // namespace grader
