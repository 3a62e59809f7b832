// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "judgement.h"

namespace exam {

/// All gradings of one patch that were made.
struct PatchRecord {
    Patch patch;
    std::vector<Judgement> whole; ///< of the whole hand-in, by seed
    std::vector<Judgement> item;  ///< of its own item alone, by seed

    bool asExpected() const;
};

/// Rates with the bounds of Clopper and Pearson (two-sided 95 %), one line each, and what stands
/// apart from them.
std::string summarise(const std::vector<PatchRecord> &records);

/// Whether something was measured, and every rate is at least what is wanted of it.
bool reachesWanted(const std::vector<PatchRecord> &records);

/// Rates and a table of all patches, as Markdown.
std::string markdown(const std::vector<PatchRecord> &records, const std::string &commit);

/// Replaces what stands between `<!-- name: begin -->` and `<!-- name: end -->`.
/// \throws ExamError  if the file has no such place
void replaceSection(const std::filesystem::path &file, const std::string &name,
                    const std::string &text);

} // namespace exam
