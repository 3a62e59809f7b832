// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "judge.h"

namespace attack {

/// One attacker, and what was seen of it at each level.
struct ReportRow {
    std::string group; ///< a letter, or `archive`
    std::string name;
    std::string tries;
    bool atCompileTime = false;
    std::map<grader::SandboxLevel, Seen> seen;
};

/// Counts over all attackers of one level, in a line each.
std::string summarise(const std::vector<ReportRow> &rows, grader::SandboxLevel level);

/// Counts, and a table of all attackers.
std::string markdown(const std::vector<ReportRow> &rows, const std::string &commit);

/// One line, for another process.
void writeSeen(std::ostream &stream, const Seen &seen);
/// \return  false if there is no further line
bool readSeen(std::istream &stream, Seen &seen);

} // namespace attack
