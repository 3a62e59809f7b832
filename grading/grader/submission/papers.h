// SPDX-License-Identifier: MIT
#pragma once

#include <grader/submission/submission.h>

#include <string>
#include <string_view>
#include <vector>

/// What a hand-in brings beside its sources: the README and the figures.
namespace grader {

/// True for `README.txt`, `readme.md`, `LEEME` ... in any case.
bool isReadmeName(std::string_view name);

bool isFigureName(std::string_view name);

/// A README as UTF-8 with LF line ends, cut to 64 KiB: for reading by people, nothing numeric
/// depends on it.
std::string readmeText(std::string_view bytes);

/// Names of the figures that the handout asks for and that are not there, `_<samples>` standing for
/// any number; a name whose words are joined in another way will do.
std::vector<std::string> missingFigures(const Submission &submission);

/// Makes notes of a README that is missing, empty or names other members, and of figures that the
/// handout asks for and that are not there.
void checkPapers(Submission &submission);

} // namespace grader
