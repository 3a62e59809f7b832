// SPDX-License-Identifier: MIT
#pragma once

namespace exam {

/// The verbs `mutants` and `variants`: grades every patch, keeps each result, prints a table of
/// expected and got, and with what certainty the rates hold.
/// \param argv  from the verb on
/// \return      the exit code: 0 every rate is what it has to be, 1 not, 2 usage, 75 interrupted
/// \throws ExamError  if a patch does not apply any more, or the grader fails
int measure(int argc, char **argv);

} // namespace exam
