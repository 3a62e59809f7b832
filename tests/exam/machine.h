// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// What a hostile hand-in must not have touched.
namespace exam {

/// Makes processes that their parents leave behind our children, so that killLeftProcesses() sees
/// them wherever they have fled to.
/// \throws ExamError  if the system refuses
void adoptOrphans();

/// Processes whose parent we are, `1234 (probe)` each, after up to a second for those that are
/// about to end. They are killed.
std::vector<std::string> killLeftProcesses();

/// Every file below a folder with its bytes.
using Snapshot = std::map<std::string, std::string>;
Snapshot takeSnapshot(const std::filesystem::path &folder);

/// Files that have come, gone or changed.
std::vector<std::string> differences(const Snapshot &before, const Snapshot &after);

/// Which of these names exist in the folders that every process may write to, or in `more`.
std::vector<std::filesystem::path> leftFiles(const std::vector<std::string> &names,
                                             const std::filesystem::path &more);

} // namespace exam
