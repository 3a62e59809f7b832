// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace grader {

/// The student edition of one of the renderer's files: what stands between the markers of graded
/// parts is taken out.
///
///     // graded: begin Warp::squareToTent() is not yet implemented!   -> throw NoriException("…");
///     // graded: begin                                                -> nothing
///     // graded: else      the lines `//# code` up to the end are uncommented
///     // graded: end
///     // graded: file      (the whole file is left out)
///
/// \param kept  functions (`Warp::squareToTent`) whose solutions stay, with what has no message
/// \return  nothing if the file is not part of the student edition
/// \throws GraderError  on a marker out of place; `file` names the file in it
std::optional<std::string> starterText(std::string_view text, const std::string &file,
                                       const std::vector<std::string> &kept = {});

/// Writes the student edition of the renderer as a project of its own: include/, compat/, src/,
/// CMakeLists.txt and the scenes of the assignment.
/// \throws GraderError  if `folder` exists and is not empty, or cannot be written
void writeStarter(const std::filesystem::path &folder);

} // namespace grader
