// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <viewer/report.h>

namespace viewer {

/// The handout's name of the picture, without suffix: "UniformTriangle".
std::string evidenceName(const catalog::WarpEntry &truth);

/// Draws maps, verdict and parameters into FOLDER/NAME.png, with the document of report_json.h as
/// its iTXt chunk "warptest", and writes that beside it as NAME.json. Makes the folder. \return the
/// picture's path \throws std::runtime_error  if they cannot be written
std::string writeEvidence(const Subject &subject, const TestReport &report,
                          const std::string &folder);

} // namespace viewer
