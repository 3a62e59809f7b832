// SPDX-License-Identifier: MIT
#pragma once

#include <grader/results/results.h>

#include <filesystem>
#include <string>

namespace grader {

/// Where the stamp of a rubric stands: `my-rubric.toml.frozen` beside it.
std::filesystem::path frozenFile(const std::filesystem::path &rubric);

/// Writes the stamp of a rubric that was tried: digests of it and of the base, and on what.
/// \throws GraderError  if it cannot be written
void freezeRubric(const std::filesystem::path &rubric, const Provenance &provenance,
                  std::size_t handIns, int seeds);

/// Compares a rubric with its stamp.
/// \return  a sentence for staff: calibrated as it is, changed since, with another program or base;
///          empty if there is no stamp
std::string describeFrozen(const std::filesystem::path &rubric, const Provenance &provenance);

} // namespace grader
