// SPDX-License-Identifier: MIT
#pragma once

#include "expectation.h"

namespace exam {

/// One folder of tests/submissions with an expected.toml.
struct Case {
    std::string name; ///< `wrong/disk_pdf_one`
    Expectation expectation;
};

/// All cases below `root`, by name; those with `pattern` in their name, all if it is empty.
/// \throws ExamError  if `root` has none, or an expected.toml cannot be read
std::vector<Case> findCases(const std::filesystem::path &root, const std::string &pattern);

/// Puts a hand-in together below `work`, which is empty: its base, without what is left out, its
/// own files laid over, packed if it is to be a zip.
/// \param norigrade  the program that writes the starter
/// \return           the folder or zip to grade
/// \throws ExamError  if a file cannot be copied, or the base or a file to leave out is not there
std::filesystem::path compose(const std::filesystem::path &root, const Case &which,
                              const std::filesystem::path &norigrade,
                              const std::filesystem::path &work);

} // namespace exam
