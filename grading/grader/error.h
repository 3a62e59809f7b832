// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace grader {

/// The world failed us (a file, a process, a rubric), or the user asked for what cannot be: a
/// message that says what, where, and what to do. Never used for what a submission does.
class GraderError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

} // namespace grader
